# Style: what clang-format and grep can see, and a short list of clang-tidy's checks (.clang-tidy,
# tests/.clang-tidy) that takes half a minute of processor time.

TIDY_SOURCES = $(filter-out docs/% tests/circuit/own/%,$(C_SOURCES))

.PHONY: lint-style lint-tidy
lint-style:
	$(call say,LINT,style)
	$Qtests/style/notices.sh
	$Qtests/style/style.sh

lint-tidy:
	$(call say,LINT,'$(words $(TIDY_SOURCES)) C files by clang-tidy')
	@mkdir -p $(BUILD)/lint
	$Qclang-tidy --quiet $(TIDY_SOURCES) -- -std=c17 -Icmodel -Isim -I$(BUILD) $(PACKAGE_CFLAGS) \
	    >$(BUILD)/lint/tidy.log 2>&1 || \
	    { grep -v 'warnings generated\.$$' $(BUILD)/lint/tidy.log; exit 1; }
