# The circuits for everything that is not the command: a table of their listed settings, made of
# their descriptions; and further forms of them, for tests/netlist and tests/coverage.

# What the longer checks Verilate or synthesise themselves; of the plain build in make sanitize too.
VERILATED ?= $(BUILD)/verilated
VERILATOR_ROOT_DIR = $(call once,VERILATOR_ROOT_DIR,$(VERILATOR) --getenv VERILATOR_ROOT)
VERILATOR_INCLUDE = $(VERILATOR_ROOT_DIR)/include

# Rewritten only when the version changes, so that a new Verilator rebuilds everything.
$(VERILATED)/version: FORCE
	@mkdir -p $(@D)
	@version=$$($(VERILATOR) --version) || \
	    { echo "no Verilator: make demo installs it" >&2; exit 1; }; \
	 echo "$$version" | cmp -s - $@ || echo "$$version" > $@
.PHONY: FORCE
FORCE:

# Those of the tree: what finds one from elsewhere needs more.
CIRCUIT_SOURCES := $(filter-out sim/circuit/own.c,$(wildcard sim/circuit/*.c))

$(BUILD)/list-settings: $(BUILD)/tests/circuits/main.o $(BUILD)/tests/netlist/pins.o \
    $(CIRCUIT_SOURCES:%.c=$(BUILD)/%.o) $(BUILD)/libglint.a
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ -lm

# A line each, as tests/circuits/main.c says.
$(BUILD)/settings: $(BUILD)/list-settings
	@$< > $@

# The name of a fault, tests/…/<name>/<module>.sed.
fault_name = $(notdir $(patsubst %/,%,$(dir $1)))

# What else is checked of a circuit.
include $(wildcard tests/circuits/*.mk)

# Each form is a directory of Verilog and the tools that it is built with (tests/circuit.sh):
# BUILD[-WRONG]/SETTING below this one.
SECOND := $(VERILATED)/second

$(SECOND)/%/made: tests/circuit.sh $(CIRCUIT_SOURCES) $(RTL) $(WRONG_CIRCUITS) | $(BUILD)/settings
	$(call say,SECOND,$*)
	$QVERILATOR=$(VERILATOR) CXX=$(CXX) tests/circuit.sh $* $(BUILD)/settings $(BUILD)/wrong $(@D)
	@touch $@

# A list of them, for tests/netlist/opinions.h: absolute, as a compiler is started elsewhere. $1:
# its file, $2: the forms
define opinion_list
$1: $(wildcard tests/circuits.mk tests/circuits/*.mk) $(2:%=$(SECOND)/%/made)
	@mkdir -p $$(@D)
	@printf '%s\n' $(2:%=$(abspath $(SECOND))/%) > $$@
endef
