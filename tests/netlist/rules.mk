# Second opinions on the circuits: netlists out of synthesis, and the Verilog Verilated in other ways
# (docs/netlists.md). A name is BUILD[-FAULT]:CIRCUIT, as tests/circuit.sh has it.

SECOND_SPECULAR  := cosine-pipelined-1 cosine-drawn-1 sign-pipelined-2 drawn-pipelined-1
SECOND_DIVIDERS  := $(foreach f,sequential pipelined,$(foreach n,6 12 16,$f-$n))
# Every gate and pipeline for the Verilog itself, which is quick to build.
SECOND_SETTINGS  := $(foreach g,$(GATES),$(foreach p,$(PIPELINES),$g-$p-1)) cosine-pipelined-4
SECOND_FAULTS    := $(foreach f,$(FAULTS),ice40-$(call wrong_name,$f):cosine-pipelined-1) \
                    $(foreach f,$(DIVIDER_FAULTS),generic-$(call wrong_name,$f):$(call wrong_form,$f)-12)
SECOND_OPINIONS  := $(foreach b,ice40 dsp generic,$(SECOND_SPECULAR:%=$b:%)) \
                    $(foreach b,ice40 generic,$(SECOND_DIVIDERS:%=$b:%)) \
                    $(foreach b,nodfg plain,$(SECOND_SETTINGS:%=$b:%) $(SECOND_DIVIDERS:%=$b:%)) \
                    $(SECOND_FAULTS)
# For make test.
SHORT_OPINIONS   := ice40:cosine-pipelined-1 generic:sequential-12 ice40:pipelined-6 \
                    nodfg:cosine-pipelined-1 plain:sequential-12 \
                    generic-late_done:sequential-12 generic-unsigned_stage:pipelined-12

# The circuits are those of the plain build in make sanitize too.
circuit_table  = glint_$(subst :,_,$(subst -,_,$1))
circuit_dir    = $(VERILATED)/second/$(subst :,/,$1)
circuit_is_divider = $(filter sequential pipelined,$(firstword $(subst -, ,$(lastword $(subst :, ,$1)))))

# $1: name
define circuit_rules
$(call circuit_dir,$1)/shim.o: $(RTL) $(wildcard sim/rtl/*.vlt tests/netlist/*.vlt tests/coverage/*.cpp) \
    $(FAULTS) $(DIVIDER_FAULTS) tests/circuit.sh $(SHIM_SOURCES) $(DIVIDER_SHIM_SOURCES) $(VERILATED)/version
	+VERILATE='$(VERILATE_TOP)' COMPILE='$$(CXX) $$(SHIM_FLAGS)' MAKE='$$(MAKE)' \
	    tests/circuit.sh $1 $(call circuit_table,$1) $$(@D)
endef
$(foreach n,$(sort $(SECOND_OPINIONS) $(SHORT_OPINIONS)),$(eval $(call circuit_rules,$n)))

# One program, and the list of its circuits (opinions.h): the short one and the whole one.
# $1: list's name, $2: its circuits, $3: the program
define circuit_program
$(BUILD)/netlist/$1.c: tests/netlist/rules.mk
	@mkdir -p $$(@D)
	(echo '/* Written by tests/netlist/rules.mk. */'; \
	 echo '#include "netlist/opinions.h"'; \
	 $(foreach n,$2,echo 'extern const glint_$(if $(call circuit_is_divider,$n),divider,rtl)_model $(call circuit_table,$n);';) \
	 echo 'const opinion opinions[] = {'; \
	 $(foreach n,$2,echo '    {"$n", $(if $(call circuit_is_divider,$n),NULL$(comma) &$(call circuit_table,$n),&$(call \
	     circuit_table,$n)$(comma) NULL)},';) \
	 echo '};'; \
	 echo 'const int opinion_count = (int)(sizeof opinions / sizeof opinions[0]);') > $$@

$(BUILD)/netlist/$1.o: $(BUILD)/netlist/$1.c tests/netlist/opinions.h
	$$(CC) -Itests $$(CFLAGS_ALL) -c $$< -o $$@

$3: $(BUILD)/tests/netlist/test_opinions.o $(BUILD)/netlist/$1.o $(foreach n,$2,$(call circuit_dir,$n)/shim.o) \
    $(BUILD)/libtest.a $(LIBRARIES)
	@mkdir -p $$(@D)
	$$(CXX) $$(LDFLAGS) -o $$@ $$(filter %.o,$$^) $(foreach n,$2,$(call circuit_dir,$n)/circuit.a) \
	    $(BUILD)/libtest.a $$(LIBRARIES) -lcmocka $$(LDLIBS)
endef
comma := ,
$(eval $(call circuit_program,short,$(SHORT_OPINIONS),$(BUILD)/tests/netlist/test_opinions))
$(eval $(call circuit_program,full,$(SECOND_OPINIONS),$(BUILD)/netlist/full))

.PHONY: netlist
netlist:
	sim/deps.sh netlist
	+$(MAKE) -j$(JOBS) $(BUILD)/netlist/full
	tests/netlist/run.sh $(BUILD)/netlist/full $(BUILD)/netlist/full.log
