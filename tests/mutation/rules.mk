# Mutation: would the bench notice a single fault of the synthesised circuits? docs/mutation.md
#
# MUTANTS=N        faults of each circuit (1000)
# MUTATION_SEED=N  chooses the faults, and is the seed of the random pins (1)
# MUTATION_SECONDS=N  for each proof that a fault changes nothing (900)

MUTANTS       ?= 1000
MUTATION_SEED ?= 1
MUTATION_SECONDS ?= 900
# The settings MUTATED, and in make test MUTATED_SHORT: tests/circuits/*.mk. SWEEP_CLOCKS_<setting>
# is how much of its sweep one gets, where that is not all.
MUTANTS_SHORT := 60
MUTATION      := $(VERILATED)/mutation

mutation_class  = Vmutants_$1

.SECONDARY: $(foreach m,$(MUTATED) $(MUTATED_SHORT),\
    $(addprefix $(MUTATION)/$m/,mutants.v netlist.stamp ports.h shim.o) \
    $(BUILD)/mutation/$m/bench)

# Rewritten only when it changes, so that only other faults rebuild the netlist.
$(MUTATED:%=$(MUTATION)/%/chosen): CHOSEN = $(MUTANTS) $(MUTATION_SEED)
$(MUTATED_SHORT:%=$(MUTATION)/%/chosen): CHOSEN = $(MUTANTS_SHORT) 1
$(MUTATION)/%/chosen: FORCE
	@mkdir -p $(@D)
	@echo "$(CHOSEN)" | cmp -s - $@ || echo "$(CHOSEN)" > $@

$(MUTATION)/%/mutants.v: $(MUTATION)/%/chosen tests/mutation/mutants.sh $(CIRCUIT_SOURCES) $(RTL) \
    | $(BUILD)/settings
	tests/mutation/mutants.sh $* $(BUILD)/settings $$(cat $<) $(@D)

$(MUTATION)/%/ports.h: $(CIRCUIT_SOURCES) | $(BUILD)/list-settings
	@mkdir -p $(@D)
	$(BUILD)/list-settings --ports $* > $@

# Names and widths are Yosys's, not ours: no lint. Verilator 5.006 gets netlists wrong without
# -fno-const-bit-op-tree (docs/netlists.md). A netlist of gates gains nothing from -O2.
$(MUTATION)/%/netlist.stamp: $(MUTATION)/%/mutants.v $(VERILATED)/version
	$(VERILATOR) --cc -O3 -fno-const-bit-op-tree --x-assign fast --x-initial unique \
	    --noassert -Wno-lint -Wno-style \
	    --prefix $(call mutation_class,$*) --Mdir $(@D)/verilated $<
	$(MAKE) -s -C $(@D)/verilated -f $(call mutation_class,$*).mk OPT_FAST=-O1 OPT_SLOW=-O0 \
	    $(call mutation_class,$*)__ALL.a >/dev/null
	@touch $@

MUTATION_SHIM = $(CXX) -std=gnu++17 -O3 -Wall -Wextra -DVM_TRACE=0 -DVM_COVERAGE=0 -DVM_SC=0 \
    -isystem $(VERILATOR_INCLUDE) -isystem $(VERILATOR_INCLUDE)/vltstd

$(MUTATION)/%/shim.o: $(MUTATION)/%/netlist.stamp $(MUTATION)/%/ports.h \
    $(wildcard tests/mutation/*.cpp tests/mutation/*.h)
	$(MUTATION_SHIM) -isystem $(@D)/verilated -I$(@D) -DMODEL=$(call mutation_class,$*) \
	    -DMUTATION_CIRCUIT='"$*"' -c tests/mutation/netlist_shim.cpp -o $@

# Verilator's own runtime, once for all.
MUTATION_RUNTIME := $(MUTATION)/runtime/verilated.o $(MUTATION)/runtime/verilated_threads.o
$(MUTATION_RUNTIME): $(MUTATION)/runtime/%.o: $(VERILATED)/version
	@mkdir -p $(@D)
	$(MUTATION_SHIM) -w -c $(VERILATOR_INCLUDE)/$*.cpp -o $@

MUTATION_OBJECTS := $(addprefix $(BUILD)/tests/mutation/,main.o bench.o sweep.o) \
                    $(BUILD)/tests/netlist/pins.o $(addprefix $(BUILD)/sim/cli/,output.o parse.o)

$(BUILD)/mutation/%/bench: $(MUTATION)/%/shim.o $(MUTATION_OBJECTS) $(MUTATION_RUNTIME) $(LIBRARIES)
	@mkdir -p $(@D)
	$(CXX) $(LDFLAGS) -o $@ $< $(MUTATION_OBJECTS) \
	    $(MUTATION)/$*/verilated/$(call mutation_class,$*)__ALL.a \
	    $(MUTATION_RUNTIME) $(LIBRARIES) $(LDLIBS)
	cp $(MUTATION)/$*/healthy.il $(MUTATION)/$*/mutants.list $(@D)/

$(BUILD)/mutation/%/verdicts.tsv: $(BUILD)/mutation/%/bench
	$< --list $(@D)/mutants.list --seed $(MUTATION_SEED) \
	    $(if $(SWEEP_CLOCKS_$*),--sweep $(SWEEP_CLOCKS_$*)) --out $@

# Fails when a fault is missed or undecided; the others are judged all the same.
$(MUTATED:%=judge-%): judge-%: $(BUILD)/mutation/%/verdicts.tsv
	tests/mutation/judge.sh $* $(<D) $< $(<D)/results.tsv $(MUTATION_SECONDS)

.PHONY: mutation $(MUTATED:%=judge-%)
mutation:
	sim/deps.sh mutation
	+$(MAKE) -k $(PARALLEL) $(MUTATED:%=judge-%)
	tests/mutation/tables.sh $(BUILD)/mutation $(MUTATED) > $(BUILD)/mutation/tables.md

build-tests: $(MUTATED_SHORT:%=$(BUILD)/mutation/%/bench)
