# The span unit's function is compared with exact rationals.

$(BUILD)/tests/span/test_span_unit: LDLIBS += -lgmp
