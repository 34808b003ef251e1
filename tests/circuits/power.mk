# What is checked of the power device beyond what every listed setting gets (tests/circuits.mk); the
# list is that of specular.mk.

# make netlist; and a wrong word of ROM 33, which the pins have to show.
OPINIONS += ice40/power_half_pipelined_1 generic/power_half_pipelined_1 \
            ice40-power_early_power/power_half_pipelined_1

# make formal: wrong circuits that the prover must notice, as in specular.mk; the proofs:
# tests/formal/power.awk.
FORMAL_FAULTS += \
    power-half-pipelined-1-0:uninvited:tests/formal/wrong/path_leaves_valid/material_path.sed \
    power-half-pipelined-1-0:in_order:tests/formal/wrong/path_silent/material_path.sed \
    power-half-pipelined-1-0:once:tests/formal/wrong/path_twice/material_path.sed \
    power-half-pipelined-1-0:frozen:tests/power/wrong/unheld_colors/color_stage.sed \
    power-half-pipelined-1-0:value:tests/power/wrong/stalled_colors/material_path.sed \
    power-half-pipelined-1-0:value:tests/formal/wrong/other_address/power_lane.sed \
    power-half-combinational-1-0:value:tests/power/wrong/no_half/power_lane.sed \
    power-half-combinational-16-7:value:tests/formal/wrong/swapped_pair/power_device.sed \
    power_roms-half:rising:tests/formal/wrong/dipping_log/power_log_rom.sed \
    power_roms-half:falling:tests/formal/wrong/short_power/power_exp_rom.sed \
    power_roms-half:halves:tests/power/wrong/early_power/power_exp_rom.sed
