report.o: sim/failure/report.c sim/failure/report.h sim/failure/failure.h \
 sim/failure/capture.h sim/lockstep/lockstep.h sim/circuit/words.h \
 sim/circuit/setting.h cmodel/glint_circuit.h cmodel/glint_signal.h \
 cmodel/glint_status.h sim/lockstep/reach.h sim/lockstep/signals.h \
 sim/lockstep/answer.h cmodel/glint_divider_device.h \
 cmodel/glint_divider.h cmodel/glint_formats.h \
 cmodel/glint_specular_device.h cmodel/glint_specular.h \
 sim/lockstep/domain.h sim/lockstep/history.h sim/lockstep/batch_pins.h \
 cmodel/glint_divider.h cmodel/glint_specular.h sim/failure/answer_form.h \
 sim/failure/json_reader.h cmodel/glint_status.h sim/failure/packet.h \
 sim/image/image.h sim/failure/shell.h sim/lockstep/answer_kind.h \
 sim/lockstep/mismatch.h sim/lockstep/twin.h sim/wave/presentation.h \
 sim/wave/gtkw.h
sim/failure/report.h:
sim/failure/failure.h:
sim/failure/capture.h:
sim/lockstep/lockstep.h:
sim/circuit/words.h:
sim/circuit/setting.h:
cmodel/glint_circuit.h:
cmodel/glint_signal.h:
cmodel/glint_status.h:
sim/lockstep/reach.h:
sim/lockstep/signals.h:
sim/lockstep/answer.h:
cmodel/glint_divider_device.h:
cmodel/glint_divider.h:
cmodel/glint_formats.h:
cmodel/glint_specular_device.h:
cmodel/glint_specular.h:
sim/lockstep/domain.h:
sim/lockstep/history.h:
sim/lockstep/batch_pins.h:
cmodel/glint_divider.h:
cmodel/glint_specular.h:
sim/failure/answer_form.h:
sim/failure/json_reader.h:
cmodel/glint_status.h:
sim/failure/packet.h:
sim/image/image.h:
sim/failure/shell.h:
sim/lockstep/answer_kind.h:
sim/lockstep/mismatch.h:
sim/lockstep/twin.h:
sim/wave/presentation.h:
sim/wave/gtkw.h:
