# Programs in which what is read from the circuits goes through planted.c: see planted.h there.
PLANTED_WRAPS := -Wl,--wrap=glint_rtl_signal_bits,--wrap=glint_divider_rtl_signal_bits \
                 -Wl,--wrap=glint_rtl_batch,--wrap=glint_divider_rtl_batch

$(BUILD)/tests/planted/test_%: LDFLAGS += $(PLANTED_WRAPS)

$(BUILD)/planted/glint: $(CLI_OBJECTS) $(BUILD)/tests/planted/planted.o $(LIBRARIES)
	@mkdir -p $(@D)
	$(CXX) $(LDFLAGS) $(PLANTED_WRAPS) -o $@ $^ $(LDLIBS)

build-tests: $(BUILD)/planted/glint
