place.o: sim/report/place.c sim/report/place.h cmodel/glint_status.h
sim/report/place.h:
cmodel/glint_status.h:
