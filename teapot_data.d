teapot_data.o: sim/render/teapot_data.c sim/render/teapot_data.h
sim/render/teapot_data.h:
