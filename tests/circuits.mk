# The circuits for everything that is not the command: a table of their listed settings, made of
# their descriptions; and further forms of them, for tests/netlist and tests/coverage.

CIRCUIT_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(wildcard sim/circuit/*.c))

$(BUILD)/list-settings: $(BUILD)/tests/settings/main.o $(BUILD)/tests/netlist/pins.o $(CIRCUIT_OBJECTS) $(BUILD)/libglint.a
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ -lm

# A line each, as tests/settings/main.c says. Rewritten only when it changes.
$(BUILD)/settings: $(BUILD)/list-settings
	@$< > $@.new && { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }

# Names of settings, by a pattern of grep over the lines of the table. For recipes.
settings_like = $$(grep -E '$1' $(BUILD)/settings | cut -d ' ' -f 2)

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
