# ROM 33 is wrong for one n only: 61/3 is a code too large.
s/10'd60  : sigma = 22'd166571/10'd60  : sigma = 22'd166572/
