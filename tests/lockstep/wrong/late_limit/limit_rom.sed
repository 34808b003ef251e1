# ROM 9 is wrong for one n only: the highlight of n = 1000 ends a code early.
s/10'd1000: limit = 19'd261359/10'd1000: limit = 19'd261360/
