# Programs in which the test's own circuits stand in for the Verilog: see tests/lockstep/mock_rtl.h.
MOCK_WRAPS := -Wl,--wrap=glint_rtl_open,--wrap=glint_rtl_destroy,--wrap=glint_rtl_clock \
              -Wl,--wrap=glint_rtl_read,--wrap=glint_rtl_shade

$(addprefix $(BUILD)/tests/,failure/test_packet failure/test_answer \
    lockstep/test_exhaustive_planted): LDFLAGS += $(MOCK_WRAPS)
