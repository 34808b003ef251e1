# Tests of rendering that compute in exact rationals.

$(BUILD)/tests/render/test_quadratic: LDLIBS += -lgmp
