# Fuzzing by libFuzzer, with AddressSanitizer and UBSan in all of the C code; the circuits are those
# of the plain build. FUZZ_SECONDS= for each target.

FUZZ_TARGETS := mesh scene eval divide render png packet
FUZZ_SECONDS ?= 20

FUZZ_SHARED  := $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/test_fuzz.c,$(wildcard tests/fuzz/*.c)))
# The command without its main().
FUZZ_COMMAND := $(filter-out %/main.o,$(CLI_OBJECTS))

$(BUILD)/tests/fuzz/test_fuzz: $(BUILD)/tests/fuzz/test_fuzz.o $(FUZZ_SHARED) $(FUZZ_COMMAND) \
    $(LIBRARIES) | $(BUILD)/tree
	$(CXX) $(LDFLAGS) -o $@ $^ -lcmocka $(LDLIBS)

ifdef FUZZING
CFLAGS_ALL += -O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
endif

$(BUILD)/fuzzers/%: $(FUZZ_SHARED) $(FUZZ_COMMAND) $(LIBRARIES) | $(BUILD)/tree
	@mkdir -p $(@D)
	clang++ -fsanitize=fuzzer,address,undefined -Wl,--defsym=LLVMFuzzerTestOneInput=fuzz_$* -o $@ \
	    $(FUZZ_SHARED) $(FUZZ_COMMAND) $(LIBRARIES) $(LDLIBS)

.PHONY: fuzz fuzz-programs
fuzz-programs: $(FUZZ_TARGETS:%=$(BUILD)/fuzzers/%)

# Circuits first: none may be built while an input is being tried.
fuzz: export GLINT_CACHE := $(abspath $(BUILD))/circuits
fuzz:
	sim/deps.sh fuzz
	+$(MAKE) $(PARALLEL) $(BUILD)/glint
	$(BUILD)/glint verify --clocks 1 --out $(BUILD)/fuzz-failure
	$(BUILD)/glint bench --seconds 0.01 >/dev/null
	+$(MAKE) $(PARALLEL) FUZZING=1 CC=clang BUILD=$(BUILD)/fuzz VERILATED=$(VERILATED) fuzz-programs
	tests/fuzz/run.sh $(BUILD)/fuzz $(FUZZ_SECONDS) $(FUZZ_TARGETS)
