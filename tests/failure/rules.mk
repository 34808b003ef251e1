# The command with a circuit that goes wrong late as its only one: what it does when a mismatch has
# to be played again from the beginning of a long run.
$(BUILD)/late/rtl_models.h: tests/failure/rules.mk
	@mkdir -p $(@D)
	(echo "#define GLINT_RTL_MODELS(X) X(glint_late_circuit)"; \
	  echo "#define GLINT_VERILATOR_VERSION \"\"") > $@

$(BUILD)/late/rtl.o: sim/rtl/rtl.c $(BUILD)/late/rtl_models.h
	$(CC) -I$(BUILD)/late $(CFLAGS_ALL) -c $< -o $@

$(BUILD)/late/glint: $(CLI_OBJECTS) $(BUILD)/late/rtl.o \
    $(BUILD)/tests/failure/late_circuit.o $(LIBRARIES)
	$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)

build-tests: $(BUILD)/late/glint
