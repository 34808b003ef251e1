# ROM 9 is asked with the cosine's x of the clock, which may be a later slot's.
s/\.address(reg1\[/.address(x[/
