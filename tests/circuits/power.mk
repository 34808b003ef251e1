# What is checked of the power device beyond what every listed setting gets (tests/circuits.mk); the
# list is that of specular.mk.

# make netlist; and a wrong word of ROM 33, which the pins have to show.
OPINIONS += ice40/power_half_pipelined_1 generic/power_half_pipelined_1 \
            ice40-power_early_power/power_half_pipelined_1
