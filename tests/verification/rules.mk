# Everything that verifies, in its full form, and the table of docs/verified.md from its results.

.PHONY: verification
verification: export GLINT_RECORDS = $(abspath $(BUILD))/verification
verification: NOTE = tests/verification/command.sh
verification:
	rm -rf $(GLINT_RECORDS)
	+$(MAKE) test
	$(NOTE) rtl-1-lockstep "RTL = C model: every register and named value, every clock, 52 settings" \
	    "lockstep, random" $(BUILD)/glint verify --seed 1
	$(NOTE) rtl-2-exhaustive \
	    "RTL = C model: every n, cosine code and W with every colour, each gate and pipeline" \
	    exhaustion $(BUILD)/glint verify --exhaustive --gate all --pipeline all
	+$(MAKE) mutation
	+$(MAKE) formal
	+$(MAKE) reference
	+$(MAKE) netlist
	+$(MAKE) coverage
	+$(MAKE) fuzz
	tests/verification/table.sh $(GLINT_RECORDS) docs/verified.md
