# The circuits for everything that is not the command: a table of their listed settings, made of
# their descriptions; and further forms of them, for tests/netlist and tests/coverage.

CIRCUIT_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(wildcard sim/circuit/*.c))

$(BUILD)/list-settings: $(BUILD)/tests/circuits/main.o $(BUILD)/tests/netlist/pins.o $(CIRCUIT_OBJECTS) $(BUILD)/libglint.a
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ -lm

# A line each, as tests/circuits/main.c says. Rewritten only when it changes.
$(BUILD)/settings: $(BUILD)/list-settings
	@$< > $@.new && { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }

# The name of a fault, tests/…/<name>/<module>.sed.
fault_name = $(notdir $(patsubst %/,%,$(dir $1)))

# What else is checked of a circuit.
include $(wildcard tests/circuits/*.mk)

# Each form is a directory of Verilog and the tools that it is built with (tests/circuit.sh):
# BUILD[-FAULT]/SETTING below this one.
SECOND := $(VERILATED)/second

$(SECOND)/%/made: tests/circuit.sh $(BUILD)/settings $(RTL) $(wildcard tests/*/wrong/*/*.sed \
    tests/*/wrong/*/*/*.sed)
	$(call say,SECOND,$*)
	$Q tests/circuit.sh $* $(BUILD)/settings $(@D)
	@touch $@

# A list of them, for tests/netlist/opinions.h. $1: its file, $2: the forms
define opinion_list
$1: tests/circuits.mk $(firstword $(wildcard tests/$(notdir $(patsubst %/,%,$(dir $1)))/rules.mk)) \
    $(2:%=$(SECOND)/%/made)
	@mkdir -p $$(@D)
	@printf '%s\n' $(2:%=$(SECOND)/%) > $$@
endef
