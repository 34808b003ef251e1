# ROM 33: one bit of one word is wrong, 2^-0 aside the highest power.
s/8'd1  : power = 13'd4085;/8'd1  : power = 13'd4084;/
