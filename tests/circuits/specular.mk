# What is checked of the specular device beyond what every listed setting gets (tests/circuits.mk).

# make mutation: synthesised, with single faults.
MUTATED += specular_cosine_pipelined_1 specular_cosine_combinational_1

# make netlist: netlists, and the Verilog itself, which is quick to build, Verilated in other ways.
OPINIONS_SPECULAR := $(addprefix specular_,cosine_pipelined_1 cosine_combinational_1 \
                     sign_pipelined_2 drawn_pipelined_1)
VERILOG_SPECULAR  := $(foreach g,cosine sign drawn,\
                         $(foreach p,combinational pipelined,specular_$g_$p_1)) \
                     specular_cosine_pipelined_4
OPINIONS          += $(foreach b,ice40 dsp generic,$(OPINIONS_SPECULAR:%=$b/%)) \
                     $(foreach b,nodfg plain,$(VERILOG_SPECULAR:%=$b/%))
# Not late_limit: ROM 9 one code too large shuts out a point whose W is 0 anyhow, whatever n is; the
# pins cannot show it.
OPINIONS          += $(foreach f,\
                         $(filter-out %/limit_rom.sed,$(wildcard tests/lockstep/wrong/*/*.sed)),\
                         ice40-$(call fault_name,$f)/specular_cosine_pipelined_1)
# Those of make test.
OPINIONS_SHORT    += ice40/specular_cosine_pipelined_1 nodfg/specular_cosine_pipelined_1

# make coverage.
COVERED += $(foreach g,cosine sign drawn,$(foreach p,combinational pipelined,specular_$g_$p_1)) \
           $(addprefix specular_,cosine_pipelined_2 sign_combinational_2 drawn_pipelined_4)

# make formal: wrong circuits that the prover must notice, PROOF:PROPERTY:FAULT, each property of
# each kind of proof at least once. The proofs: tests/formal/specular.awk.
FORMAL_FAULTS += \
    device-cosine-pipelined-1-0:uninvited:tests/formal/wrong/reset_leaves_valid/specular_device.sed \
    device-cosine-pipelined-1-0:in_order:tests/lockstep/wrong/silent/specular_device.sed \
    device-cosine-pipelined-1-0:once:tests/formal/wrong/twice/specular_device.sed \
    device-cosine-pipelined-1-0:frozen:tests/formal/wrong/unfrozen/specular_lane.sed \
    device-cosine-pipelined-1-0:value:tests/lockstep/wrong/unstallable/specular_lane.sed \
    device-cosine-pipelined-1-0:value:tests/formal/wrong/other_n/specular_device.sed \
    device-cosine-combinational-1-0:value:tests/lockstep/wrong/truncating/color_multiplier.sed \
    device-cosine-combinational-16-7:value:tests/formal/wrong/swapped_lanes/specular_device.sed \
    gates-pipelined-1-0:gates_equal:tests/formal/wrong/wrong_sign/specular_lane.sed \
    roms:sigma:tests/lockstep/wrong/sigma_off_by_one/sigma_rom.sed \
    roms:range:tests/formal/wrong/sigma_over_range/sigma_rom.sed \
    roms:limit:tests/lockstep/wrong/late_limit/limit_rom.sed
