# Coverage: of the Verilog by lines and toggles, in the settings COVERED (tests/circuits/*.mk), of
# the C by gcov (docs/coverage.md).

COVERAGE := $(BUILD)/coverage

$(eval $(call opinion_list,$(COVERAGE)/circuits,$(COVERED:%=coverage/%)))

$(COVERAGE)/drive: $(BUILD)/tests/coverage/drive.o $(BUILD)/libtest.a $(LIBRARIES) | $(BUILD)/tree
	@mkdir -p $(@D)
	$(CC) $(LDFLAGS) -o $@ $^ $(LDLIBS)

.PHONY: coverage coverage-rtl coverage-c
coverage: coverage-rtl coverage-c

coverage-rtl:
	sim/deps.sh coverage
	+$(MAKE) $(PARALLEL) $(COVERAGE)/drive $(COVERAGE)/circuits
	GLINT_BUILD=$(BUILD) tests/coverage/rtl.sh $(COVERAGE)/drive $(COVERAGE)

# The tests once more, compiled so that gcov counts, also from several threads; the circuits are
# those of the plain build. Counting makes the loops over the whole domain slow, so they take the
# strides of the sanitizers' build; and gcc, optimising less, warns of what cannot happen.
COVERAGE_C = $(MAKE) BUILD=$(COVERAGE)/c VERILATED=$(VERILATED) LDFLAGS='$(LDFLAGS) --coverage' \
    CFLAGS='$(CFLAGS) -O1 --coverage -fprofile-update=atomic -DGLINT_SANITIZED=1 -Wno-error'

# It limits file sizes, including gcov's own, so its result is ignored; it runs only for coverage.
COVERAGE_LIMITED = $(COVERAGE)/c/tests/abuse/test_abuse_outputs
COVERAGE_TESTS   = $(TEST_SOURCES:%.c=$(COVERAGE)/c/%)

coverage-c: export GLINT_CACHE := $(abspath $(BUILD))/circuits
coverage-c:
	sim/deps.sh coverage
	+$(COVERAGE_C) $(PARALLEL) build-tests
	find $(COVERAGE)/c -name '*.gcda' -delete
	date +%s >$(COVERAGE)/c/begin
	+GLINT_RECORDS= GLINT_REFERENCE_STEP=61 $(COVERAGE_C) \
	    TEST_PROGRAMS="$(filter-out $(COVERAGE_LIMITED),$(COVERAGE_TESTS))" run-tests
	-GLINT_RECORDS= GLINT=$(COVERAGE)/c/glint GLINT_BUILD=$(COVERAGE)/c $(COVERAGE_LIMITED) \
	    >$(COVERAGE)/limited.log 2>&1
	tests/coverage/c.sh $(COVERAGE) $$(($$(date +%s) - $$(cat $(COVERAGE)/c/begin)))
