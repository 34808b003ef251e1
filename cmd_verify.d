cmd_verify.o: sim/cli/cmd_verify.c sim/cli/build_first.h sim/rtl/rtl.h \
 sim/circuit/setting.h cmodel/glint_circuit.h cmodel/glint_signal.h \
 cmodel/glint_status.h sim/cli/circuit_options.h sim/cli/options.h \
 sim/cli/commands.h sim/cli/failure_output.h sim/failure/packet.h \
 sim/failure/failure.h sim/failure/capture.h sim/lockstep/lockstep.h \
 sim/circuit/words.h sim/lockstep/reach.h sim/lockstep/signals.h \
 sim/lockstep/answer.h cmodel/glint_divider_device.h \
 cmodel/glint_divider.h cmodel/glint_formats.h \
 cmodel/glint_specular_device.h cmodel/glint_specular.h \
 sim/lockstep/domain.h sim/lockstep/history.h sim/lockstep/batch_pins.h \
 cmodel/glint_divider.h cmodel/glint_specular.h sim/image/image.h \
 cmodel/glint_status.h sim/cli/info_circuit.h sim/cli/output.h \
 sim/cli/verify_reach.h sim/failure/shell.h sim/lockstep/mismatch.h \
 sim/lockstep/twin.h
sim/cli/build_first.h:
sim/rtl/rtl.h:
sim/circuit/setting.h:
cmodel/glint_circuit.h:
cmodel/glint_signal.h:
cmodel/glint_status.h:
sim/cli/circuit_options.h:
sim/cli/options.h:
sim/cli/commands.h:
sim/cli/failure_output.h:
sim/failure/packet.h:
sim/failure/failure.h:
sim/failure/capture.h:
sim/lockstep/lockstep.h:
sim/circuit/words.h:
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
sim/image/image.h:
cmodel/glint_status.h:
sim/cli/info_circuit.h:
sim/cli/output.h:
sim/cli/verify_reach.h:
sim/failure/shell.h:
sim/lockstep/mismatch.h:
sim/lockstep/twin.h:
