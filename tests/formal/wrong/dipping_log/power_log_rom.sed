# ROM 9 falls at its last word.
s/8'd255: g = 12'd[0-9]*/8'd255: g = 12'd1024/
