# The C model against an independent reference in exact rationals, over the whole domain.

$(BUILD)/tests/reference/test_reference: LDLIBS += -lgmp
$(BUILD)/tests/reference/test_reference: LDFLAGS += -Wl,--wrap=glint_specular_batch

.PHONY: reference
reference:
	sim/deps.sh test
	+$(MAKE) $(PARALLEL) $(BUILD)/tests/reference/test_reference
	tests/reference/run.sh $(BUILD)/tests/reference/test_reference $(BUILD)/reference.log
