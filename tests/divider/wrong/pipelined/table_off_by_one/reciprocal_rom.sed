# One entry of the table, a seventh with twelve shifts, is a code too large.
s/8'd7 : bits = 13'd585;/8'd7 : bits = 13'd586;/
