# Definitions changed by one edit each, in copies of the tree (tests/formats/try.sh).

FORMATS_DRIVE := tests/formats/drive.c \
                 $(wildcard sim/circuit/*.c sim/lockstep/*.c sim/rtl/*.c sim/file/*.c \
                            sim/thread/*.c)

$(BUILD)/tests/formats/drive: $(FORMATS_DRIVE:%.c=$(BUILD)/%.o) $(BUILD)/libglint.a | $(BUILD)/tree
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# A port of more than 64 bits; a sign instead of a limit, and the multipliers one behind the other;
# the integer digits of a W above 1.
FORMATS_CIRCUITS := cosine-pipelined-4 sign-combinational-1 drawn-pipelined-1

.PHONY: formats
formats:
	sim/deps.sh formats
	@export GLINT_CACHE=$(abspath $(BUILD)/circuits); \
	for bits in 16 17 18 19 20; do \
	    echo "GLINT_COS_FRAC_BITS $$bits"; \
	    BUILD=$(BUILD) tests/formats/try.sh $(BUILD)/formats/$$bits GLINT_COS_FRAC_BITS $$bits \
	        $(FORMATS_CIRCUITS) || exit 1; \
	done
