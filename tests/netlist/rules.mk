# Second opinions on the circuits: netlists out of synthesis, and the Verilog Verilated in other ways
# (docs/netlists.md). A name is BUILD[-FAULT]:CIRCUIT, as tests/circuit.sh has it.

SECOND_SPECULAR  := cosine-pipelined-1 cosine-combinational-1 sign-pipelined-2 drawn-pipelined-1
SECOND_DIVIDERS  := $(foreach f,sequential pipelined,$(foreach n,6 12 16,$f-$n))
# Every gate and pipeline for the Verilog itself, which is quick to build.
SECOND_SETTINGS  := $(foreach g,$(GATES),$(foreach p,$(PIPELINES),$g-$p-1)) cosine-pipelined-4
# Not late_limit: ROM 9 one code too large shuts out a point whose W is 0 anyhow, whatever n is; the pins
# cannot show it.
SECOND_FAULTS    := $(foreach f,$(filter-out %/limit_rom.sed,$(FAULTS)),ice40-$(call wrong_name,$f):cosine-pipelined-1) \
                    $(foreach f,$(DIVIDER_FAULTS),generic-$(call wrong_name,$f):$(call wrong_form,$f)-12)
SECOND_OPINIONS  := $(foreach b,ice40 dsp generic,$(SECOND_SPECULAR:%=$b:%)) \
                    $(foreach b,ice40 generic,$(SECOND_DIVIDERS:%=$b:%)) \
                    $(foreach b,nodfg plain,$(SECOND_SETTINGS:%=$b:%) $(SECOND_DIVIDERS:%=$b:%)) \
                    $(SECOND_FAULTS)
# For make test.
SHORT_OPINIONS   := ice40:cosine-pipelined-1 generic:sequential-12 ice40:pipelined-6 \
                    nodfg:cosine-pipelined-1 plain:sequential-12 \
                    generic-late_done:sequential-12 generic-unsigned_stage:pipelined-12

$(foreach n,$(sort $(SECOND_OPINIONS) $(SHORT_OPINIONS)),$(eval $(call circuit_rules,$n)))

$(eval $(call circuit_program,$(BUILD)/netlist/short,$(SHORT_OPINIONS),$(BUILD)/tests/netlist/test_opinions,\
    $(BUILD)/tests/netlist/test_opinions.o))
$(eval $(call circuit_program,$(BUILD)/netlist/full,$(SECOND_OPINIONS),$(BUILD)/netlist/opinions,\
    $(BUILD)/tests/netlist/test_opinions.o))

.PHONY: netlist
netlist:
	sim/deps.sh netlist
	+$(MAKE) -j$(JOBS) $(BUILD)/netlist/opinions
	tests/netlist/run.sh $(BUILD)/netlist/opinions $(BUILD)/netlist/opinions.log
