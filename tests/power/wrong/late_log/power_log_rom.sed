# ROM 9: one word, at x around 0.43, is one code too large.
s/8'd110: g = 12'd483;/8'd110: g = 12'd484;/
