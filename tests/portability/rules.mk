# The C model on other kinds of machine: with musl, which make test tries too, and on one that
# stores the highest byte first, by qemu (some 470 MB of packages, hence not in make test).

$(BUILD)/tests/portability/test_portability: LDLIBS += -lgmp

.PHONY: portability
portability:
	sim/deps.sh portability
	+$(MAKE) $(PARALLEL) $(BUILD)/tests/portability/test_portability
	tests/run.sh $(BUILD)/test-logs $(BUILD)/tests/portability/test_portability
