# What each highlight unit costs, side by side: docs/compare.md. The tools stay in
# $(BUILD)/compare, as do their results, so that a rerun makes only what has changed.
#
# ONLY=power  that circuit alone

$(BUILD)/glint-compare: $(BUILD)/sim/compare/main.o $(LIBRARIES) | $(BUILD)/tree
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# Linked with the tests, so that it is never found broken by the one who measures.
build-tests: $(BUILD)/glint-compare

.PHONY: compare
compare:
	sim/deps.sh compare
	+$(MAKE) $(PARALLEL) $(BUILD)/glint-compare
	sim/compare/compare.sh $(BUILD) $(JOBS) $(ONLY)
