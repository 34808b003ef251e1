# Second opinions on the circuits: netlists out of synthesis, and the Verilog Verilated in other ways
# (docs/netlists.md). A name is BUILD[-FAULT]/SETTING, as tests/circuit.sh has it.

SECOND_SPECULAR  := $(addprefix specular_,cosine_pipelined_1 cosine_combinational_1 sign_pipelined_2 \
                    drawn_pipelined_1)
SECOND_DIVIDERS  := $(foreach f,sequential pipelined,$(foreach n,6 12 16,divider_$f_$n))
# Every gate and pipeline for the Verilog itself, which is quick to build.
SECOND_SETTINGS  := $(foreach g,cosine sign drawn,$(foreach p,combinational pipelined,specular_$g_$p_1)) \
                    specular_cosine_pipelined_4
# Not late_limit: ROM 9 one code too large shuts out a point whose W is 0 anyhow, whatever n is; the pins
# cannot show it.
fault_name        = $(notdir $(patsubst %/,%,$(dir $1)))
SECOND_FAULTS    := $(foreach f,$(filter-out %/limit_rom.sed,$(wildcard tests/lockstep/wrong/*/*.sed)),\
                        ice40-$(call fault_name,$f)/specular_cosine_pipelined_1) \
                    $(foreach f,sequential pipelined,$(foreach w,$(wildcard tests/divider/wrong/$f/*/*.sed),\
                        generic-$(call fault_name,$w)/divider_$f_12))
SECOND_OPINIONS  := $(foreach b,ice40 dsp generic,$(SECOND_SPECULAR:%=$b/%)) \
                    $(foreach b,ice40 generic,$(SECOND_DIVIDERS:%=$b/%)) \
                    $(foreach b,nodfg plain,$(SECOND_SETTINGS:%=$b/%) $(SECOND_DIVIDERS:%=$b/%)) \
                    $(SECOND_FAULTS)
# For make test.
SHORT_OPINIONS   := ice40/specular_cosine_pipelined_1 generic/divider_sequential_12 ice40/divider_pipelined_6 \
                    nodfg/specular_cosine_pipelined_1 plain/divider_sequential_12 \
                    generic-late_done/divider_sequential_12 generic-unsigned_stage/divider_pipelined_12

$(eval $(call opinion_list,$(BUILD)/netlist/short,$(SHORT_OPINIONS)))
$(eval $(call opinion_list,$(BUILD)/netlist/full,$(SECOND_OPINIONS)))

$(BUILD)/tests/netlist/test_opinions: LDFLAGS += $(PLANTED_WRAPS)
build-tests: $(BUILD)/netlist/short

.PHONY: netlist
netlist:
	sim/deps.sh netlist
	+$(MAKE) -j$(JOBS) $(BUILD)/tests/netlist/test_opinions $(BUILD)/netlist/full
	GLINT_OPINIONS=$(BUILD)/netlist/full tests/netlist/run.sh $(BUILD)/tests/netlist/test_opinions \
	    $(BUILD)/netlist/opinions.log
