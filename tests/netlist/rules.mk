# Second opinions on the circuits: netlists out of synthesis, and the Verilog Verilated in other
# ways (docs/netlists.md): OPINIONS, and OPINIONS_SHORT in make test (tests/circuits/*.mk). A name
# is BUILD[-FAULT]/SETTING, as tests/circuit.sh has it.

$(eval $(call opinion_list,$(BUILD)/netlist/short,$(OPINIONS_SHORT)))
$(eval $(call opinion_list,$(BUILD)/netlist/full,$(OPINIONS)))

$(BUILD)/tests/netlist/test_opinions: LDFLAGS += $(PLANTED_WRAPS)
build-tests: $(BUILD)/netlist/short

.PHONY: netlist
netlist:
	sim/deps.sh netlist
	+$(MAKE) $(PARALLEL) $(BUILD)/tests/netlist/test_opinions $(BUILD)/netlist/full
	GLINT_OPINIONS=$(BUILD)/netlist/full tests/netlist/run.sh $(BUILD)/tests/netlist/test_opinions \
	    $(BUILD)/netlist/opinions.log
