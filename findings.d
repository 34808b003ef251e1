findings.o: sim/report/findings.c sim/report/findings.h
sim/report/findings.h:
