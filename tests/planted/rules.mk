# Programs in which what is read from the circuits goes through planted.c: see planted.h there.
PLANTED_WRAPS := $(foreach f,open destroy read shade divide,-Wl,--wrap=glint_rtl_$f)

$(BUILD)/tests/planted/test_%: LDFLAGS += $(PLANTED_WRAPS)

$(BUILD)/planted/glint: $(CLI_OBJECTS) $(BUILD)/tests/planted/planted.o $(LIBRARIES) \
    | $(BUILD)/tree
	@mkdir -p $(@D)
	$(CXX) $(LDFLAGS) $(PLANTED_WRAPS) -o $@ $^ $(LDLIBS)

build-tests: $(BUILD)/planted/glint
