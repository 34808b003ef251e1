import.o: sim/render/import.c sim/render/detail.h cmodel/glint_status.h \
 sim/render/remarks.h sim/render/mesh.h sim/render/import.h \
 sim/render/imported.h sim/render/groups.h sim/render/smooth.h \
 sim/render/left_out.h sim/render/skin.h sim/render/source.h \
 sim/render/triangulate.h
sim/render/detail.h:
cmodel/glint_status.h:
sim/render/remarks.h:
sim/render/mesh.h:
sim/render/import.h:
sim/render/imported.h:
sim/render/groups.h:
sim/render/smooth.h:
sim/render/left_out.h:
sim/render/skin.h:
sim/render/source.h:
sim/render/triangulate.h:
