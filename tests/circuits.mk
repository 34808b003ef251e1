# What the longer checks Verilate themselves, beside what a running glint builds: with other options, of
# netlists, with counters.
VERILATED    ?= $(BUILD)/verilated
VERILATOR_ROOT_DIR = $(shell $(VERILATOR) --getenv VERILATOR_ROOT 2>/dev/null)
GATES        := cosine sign drawn
PIPELINES    := combinational pipelined
gate_number      = $(if $(filter cosine,$1),0,$(if $(filter sign,$1),1,2))
pipeline_number  = $(if $(filter combinational,$1),0,1)
upper            = $(shell echo $1 | tr a-z A-Z)
field            = $(word $2,$(subst -, ,$1))
divider_top      = $(if $(filter sequential,$(call field,$1,1)),shift_divider,pipelined_divider)

SHIM_FLAGS = -std=gnu++17 -O3 -Wall -Wextra -Icmodel -Isim/rtl \
             -isystem $(VERILATOR_ROOT_DIR)/include -isystem $(VERILATOR_ROOT_DIR)/include/vltstd \
             -DVM_TRACE=1 -DVM_TRACE_FST=1 -DVM_COVERAGE=0 -DVM_SC=0
VERILATE_TOP = $(VERILATOR) --cc --trace-fst -O3 --x-assign fast --x-initial fast --noassert

# Rewritten only when the version changes, so that a new Verilator makes all of it anew.
$(VERILATED)/version: FORCE
	@mkdir -p $(@D)
	@version=$$($(VERILATOR) --version) || { echo "no Verilator: make demo installs it" >&2; exit 1; }; \
	 echo "$$version" | cmp -s - $@ || echo "$$version" > $@
.PHONY: FORCE
FORCE:

# Further builds of the circuits, beside those of the Makefile, and programs made of lists of them: for
# tests/netlist and tests/coverage. A name is BUILD[-FAULT]:CIRCUIT, as tests/circuit.sh has it.

# The circuits are those of the plain build in make sanitize too.
circuit_table      = glint_$(subst :,_,$(subst -,_,$1))
circuit_dir        = $(VERILATED)/second/$(subst :,/,$1)
circuit_is_divider = $(filter sequential pipelined,$(firstword $(subst -, ,$(lastword $(subst :, ,$1)))))
circuit_type       = glint_$(if $(call circuit_is_divider,$1),divider,rtl)_model
comma             := ,
circuit_entry      = {"$1", $(if $(call circuit_is_divider,$1),NULL$(comma) &,&)$(call circuit_table,$1)$(if \
                     $(call circuit_is_divider,$1),,$(comma) NULL)},

# $1: name
define circuit_rules
$(call circuit_dir,$1)/shim.o: tests/circuit.sh $(RTL) $(FAULTS) $(DIVIDER_FAULTS) $(SHIM_SOURCES) \
    $(DIVIDER_SHIM_SOURCES) $(wildcard sim/rtl/*.vlt tests/netlist/*.vlt tests/coverage/*pp) $(VERILATED)/version
	+VERILATE='$(VERILATE_TOP)' COMPILE='$$(CXX) $$(SHIM_FLAGS)' MAKE='$$(MAKE)' \
	    tests/circuit.sh $1 $(call circuit_table,$1) $$(@D)
endef

# A program and its list of circuits (tests/netlist/opinions.h), written beside its objects.
# $1: the list's file without .c, $2: its circuits, $3: the program, $4: its other objects
define circuit_program
$1.c: tests/netlist/rules.mk tests/coverage/rules.mk
	@mkdir -p $$(@D)
	(echo '/* Written by tests/circuits.mk. */'; \
	 echo '#include "netlist/opinions.h"'; \
	 $(foreach n,$2,echo 'extern const $(call circuit_type,$n) $(call circuit_table,$n);';) \
	 echo 'const opinion opinions[] = {'; \
	 $(foreach n,$2,echo '    $(call circuit_entry,$n)';) \
	 echo '};'; \
	 echo 'const int opinion_count = (int)(sizeof opinions / sizeof opinions[0]);') > $$@

$1.o: $1.c tests/netlist/opinions.h
	$$(CC) -Itests $$(CFLAGS_ALL) -c $$< -o $$@

$3: $4 $1.o $(foreach n,$2,$(call circuit_dir,$n)/shim.o) $(BUILD)/libtest.a $(LIBRARIES)
	@mkdir -p $$(@D)
	$$(CXX) $$(LDFLAGS) -o $$@ $$(filter %.o,$$^) $(foreach n,$2,$(call circuit_dir,$n)/circuit.a) \
	    $(BUILD)/libtest.a $$(LIBRARIES) -lcmocka $$(LDLIBS)
endef
