# done is not taken back before the next start.
s/done <= 1'b0;/done <= done \&\& !start;/
