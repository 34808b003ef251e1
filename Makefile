# Glint: `make demo` and `make test` do everything; `make help` lists the rest.
#
# BUILD=DIR     where everything that is made goes (build)
# CC, CXX       the compilers (gcc, g++)
# SANITIZE=1    the C code with AddressSanitizer and UBSan (see the target sanitize)
# PREFIX=DIR    where make install puts things (/usr/local); DESTDIR=DIR: what stands before it
# NO_INSTALL=1  say which Debian packages are missing instead of installing them

# Verilator's own makefiles cannot work below a directory with a space in its name.
ifneq ($(word 2,$(CURDIR)),)
$(error the path of this directory has a space: move the tree to one without)
endif

BUILD     ?= build
CC         = gcc
CXX        = g++
VERILATOR ?= verilator
PREFIX    ?= /usr/local
JOBS      ?= $(shell nproc)

PACKAGES   := libpng freetype2 assimp libcjson libcmark-gfm nettle
PACKAGE_CFLAGS := $(shell pkg-config --cflags $(PACKAGES) 2>/dev/null)
PACKAGE_LIBS   := $(shell pkg-config --libs $(PACKAGES) 2>/dev/null)
WARNINGS   := -Wall -Wextra -Wpedantic -Wconversion -Werror
# No contraction: a frame has the same bits on every machine.
CFLAGS_ALL := -std=c17 -O3 -g -ffp-contract=off -fno-math-errno $(WARNINGS) -MMD -MP \
              -Icmodel -Isim -I$(BUILD) $(PACKAGE_CFLAGS) $(CFLAGS)
LDLIBS      = $(PACKAGE_LIBS) -lz -lm -lpthread

ifdef SANITIZE
CFLAGS_ALL += -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
LDFLAGS    += -fsanitize=address,undefined
endif

.DELETE_ON_ERROR:
.PHONY: all demo test bench wave report lint clean help install generate build-all sanitize

all: $(BUILD)/glint

# ---- The C model: libglint, and the generator of what rtl/ and sim/rtl/ include --------------------

MODEL_SOURCES := $(filter-out cmodel/gen.c,$(wildcard cmodel/*.c))
MODEL_OBJECTS := $(MODEL_SOURCES:%.c=$(BUILD)/%.o)

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_ALL) -c $< -o $@

$(BUILD)/libglint.a: $(MODEL_OBJECTS)
	rm -f $@
	ar rcs $@ $^

$(BUILD)/glint-gen: $(BUILD)/cmodel/gen.o $(BUILD)/libglint.a
	$(CC) $(LDFLAGS) -o $@ $^ -lm

# What is generated is committed; `make generate` makes it anew, and a test compares. A file that stays
# the same is not touched: everything Verilated depends on it.
GENERATED := rtl/glint_formats.vh:formats rtl/sigma_rom.v:sigma-rom rtl/limit_rom.v:limit-rom \
             rtl/reciprocal_rom.v:reciprocal-rom sim/rtl/specular_signals.vlt:signals \
             sim/rtl/divider_signals.vlt:divider-signals

generate: $(BUILD)/glint-gen
	@for pair in $(GENERATED); do \
	    file=$${pair%%:*}; \
	    $(BUILD)/glint-gen $(BUILD)/generated $${pair##*:} || exit 1; \
	    cmp -s $(BUILD)/generated $$file || { cp $(BUILD)/generated $$file && echo "$$file is new"; } || exit 1; \
	done; \
	rm $(BUILD)/generated

# ---- The Verilog under Verilator: one build for each setting ---------------------------------------

VERILATED    ?= $(BUILD)/verilated
VERILATOR_ROOT_DIR = $(shell $(VERILATOR) --getenv VERILATOR_ROOT 2>/dev/null)
RTL          := $(wildcard rtl/*.v rtl/*.vh)
GATES        := cosine sign drawn
PIPELINES    := drawn pipelined
LANE_COUNTS  := 1 2 4 8 16
# Every setting with its signals readable, for lockstep and waveforms; and, for speed, the settings
# that frames and bench use once more without (sim/rtl/rtl.h).
OBSERVED     := $(foreach g,$(GATES),$(foreach p,$(PIPELINES),$(foreach l,$(LANE_COUNTS),$g-$p-$l)))
FAST         := $(LANE_COUNTS:%=cosine-pipelined-%-fast) \
                $(foreach x,cosine-drawn sign-drawn sign-pipelined drawn-drawn drawn-pipelined,$x-16-fast)
MODELS       := $(OBSERVED) $(FAST)

gate_number      = $(if $(filter cosine,$1),0,$(if $(filter sign,$1),1,2))
pipeline_number  = $(if $(filter drawn,$1),0,1)
upper            = $(shell echo $1 | tr a-z A-Z)
field            = $(word $2,$(subst -, ,$1))

SHIM_FLAGS = -std=gnu++17 -O3 -Wall -Wextra -Icmodel -Isim/rtl \
             -isystem $(VERILATOR_ROOT_DIR)/include -isystem $(VERILATOR_ROOT_DIR)/include/vltstd \
             -DVM_TRACE=1 -DVM_TRACE_FST=1 -DVM_COVERAGE=0 -DVM_SC=0
VERILATE_TOP = $(VERILATOR) --cc --trace-fst -O3 --x-assign fast --x-initial fast --noassert
VERILATE     = $(VERILATE_TOP) --top specular_device
# $1: model name, gate-pipeline-lanes or gate-pipeline-lanes-fast
verilate_model = $(VERILATE) --prefix V$(subst -,_,$1) --Mdir $(VERILATED)/$1 \
    -GGATE=$(call gate_number,$(call field,$1,1)) \
    -GPIPELINED=$(call pipeline_number,$(call field,$1,2)) -GLANES=$(call field,$1,3) \
    -Irtl $(if $(call field,$1,4),,sim/rtl/specular_signals.vlt) rtl/specular_device.v
compile_shim = $(CXX) $(SHIM_FLAGS) -isystem $(VERILATED)/$1 -DMODEL=V$(subst -,_,$1) \
    -DGLINT_MODEL_TABLE=glint_rtl_model_$(subst -,_,$1) \
    -DGLINT_MODEL_GATE=GLINT_GATE_$(call upper,$(call field,$1,1)) \
    -DGLINT_MODEL_PIPELINE=GLINT_PIPELINE_$(call upper,$(call field,$1,2)) \
    -DGLINT_MODEL_LANES=$(call field,$1,3) \
    -DGLINT_MODEL_OBSERVED=$(if $(call field,$1,4),false,true) -c sim/rtl/model_shim.cpp -o $2

SHIM_SHARED  := sim/rtl/circuit.hpp $(wildcard cmodel/*.h)
SHIM_SOURCES := sim/rtl/model_shim.cpp sim/rtl/rtl_model.h $(SHIM_SHARED)

# What pattern rules make on the way to something else is kept (.SECONDARY, with names): make would
# delete it. Without names that would be said of every file, and none that is missing be made again
# while what is made of it is there.
.SECONDARY: $(MODELS:%=$(VERILATED)/%/verilated.stamp)

$(VERILATED)/%/verilated.stamp: $(RTL) sim/rtl/specular_signals.vlt $(VERILATED)/version
	@mkdir -p $(@D)
	$(call verilate_model,$*)
	$(MAKE) -s -C $(@D) -f V$(subst -,_,$*).mk \
	    OPT_FAST=$(if $(call field,$*,4),-O3,-O1) V$(subst -,_,$*)__ALL.a >/dev/null
	@touch $@

$(VERILATED)/shims/%.o: $(VERILATED)/%/verilated.stamp $(SHIM_SOURCES)
	@mkdir -p $(@D)
	$(call compile_shim,$*,$@)

# The dividers: form-n for each number of shifts n.
DIVIDER_SHIFTS := 6 7 8 9 10 11 12 13 14 15 16
DIVIDERS       := $(foreach f,sequential pipelined,$(DIVIDER_SHIFTS:%=$f-%))
divider_top     = $(if $(filter sequential,$(call field,$1,1)),shift_divider,pipelined_divider)
divider_class   = Vdivider_$(subst -,_,$1)

$(DIVIDERS:%=$(VERILATED)/divider-%/verilated.stamp): $(VERILATED)/divider-%/verilated.stamp: \
    $(RTL) sim/rtl/divider_signals.vlt $(VERILATED)/version
	@mkdir -p $(@D)
	$(VERILATE_TOP) --prefix $(call divider_class,$*) --top $(call divider_top,$*) --Mdir $(@D) \
	    -GSHIFTS=$(call field,$*,2) -Irtl sim/rtl/divider_signals.vlt rtl/$(call divider_top,$*).v
	$(MAKE) -s -C $(@D) -f $(call divider_class,$*).mk OPT_FAST=-O2 \
	    $(call divider_class,$*)__ALL.a >/dev/null
	@touch $@

DIVIDER_SHIM_SOURCES := sim/rtl/divider_shim.cpp sim/rtl/divider_model.h $(SHIM_SHARED)

$(VERILATED)/shims/divider-%.o: $(VERILATED)/divider-%/verilated.stamp $(DIVIDER_SHIM_SOURCES)
	@mkdir -p $(@D)
	$(CXX) $(SHIM_FLAGS) -isystem $(VERILATED)/divider-$* -DMODEL=$(call divider_class,$*) \
	    -DGLINT_MODEL_TABLE=glint_divider_model_$(subst -,_,$*) \
	    -DGLINT_MODEL_SHIFTS=$(call field,$*,2) \
	    $(if $(filter pipelined,$(call field,$*,1)),-DGLINT_MODEL_PIPELINED) \
	    -c sim/rtl/divider_shim.cpp -o $@

# Verilator's own runtime, compiled once for all models.
RUNTIME := $(patsubst %,$(VERILATED)/runtime/%.o,verilated verilated_fst_c verilated_threads)

$(VERILATED)/runtime/%.o: $(VERILATED)/version
	@mkdir -p $(@D)
	$(CXX) $(SHIM_FLAGS) -w -c $(VERILATOR_ROOT_DIR)/include/$*.cpp -o $@

$(VERILATED)/libmodels.a: $(MODELS:%=$(VERILATED)/shims/%.o) $(DIVIDERS:%=$(VERILATED)/shims/divider-%.o) \
    $(RUNTIME)
	rm -f $@ $@.mri
	(echo "create $@"; for o in $^; do echo "addmod $$o"; done; \
	 for m in $(MODELS); do echo "addlib $(VERILATED)/$$m/V$$(echo $$m | tr - _)__ALL.a"; done; \
	 for d in $(DIVIDERS); do \
	     echo "addlib $(VERILATED)/divider-$$d/Vdivider_$$(echo $$d | tr - _)__ALL.a"; done; \
	 echo save; echo end) > $@.mri
	ar -M < $@.mri

# Rewritten only when the version changes, so that a new Verilator makes all circuits anew.
$(VERILATED)/version: FORCE
	@mkdir -p $(@D)
	@version=$$($(VERILATOR) --version) || { echo "no Verilator: make demo installs it" >&2; exit 1; }; \
	 echo "$$version" | cmp -s - $@ || echo "$$version" > $@
.PHONY: FORCE
FORCE:

$(BUILD)/rtl_models.h: Makefile $(VERILATED)/version
	@mkdir -p $(@D)
	(echo "/* Written by the Makefile: one table for each Verilated build. */"; \
	 echo "#define GLINT_RTL_MODELS(X) \\"; \
	 for m in $(MODELS); do echo "    X(glint_rtl_model_$$(echo $$m | tr - _)) \\"; done; echo; \
	 echo "#define GLINT_DIVIDER_MODELS(X) \\"; \
	 for d in $(DIVIDERS); do echo "    X(glint_divider_model_$$(echo $$d | tr - _)) \\"; done; echo; \
	 echo "#define GLINT_VERILATOR_VERSION \"$$(cat $(VERILATED)/version)\"") > $@

# ---- What drives them: libglint-sim and the command ------------------------------------------------

SIM_SOURCES := $(filter-out $(wildcard sim/cli/*.c),$(wildcard sim/*/*.c))
SIM_OBJECTS := $(SIM_SOURCES:%.c=$(BUILD)/%.o)
CLI_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(wildcard sim/cli/*.c))

$(BUILD)/sim/rtl/rtl.o $(BUILD)/sim/rtl/divider_rtl.o: $(BUILD)/rtl_models.h
# The reader and the writer of FST files come with Verilator.
$(BUILD)/sim/wave/waveform.o $(BUILD)/sim/failure/wave.o: CFLAGS_ALL += -isystem $(VERILATOR_ROOT_DIR)/include

# Loops whose speed is measured; see the file.
$(BUILD)/sim/bench/formulas.o: CFLAGS_ALL += -ffast-math

$(BUILD)/libglint-sim.a: $(SIM_OBJECTS)
	rm -f $@
	ar rcs $@ $^

LIBRARIES = $(BUILD)/libglint-sim.a $(VERILATED)/libmodels.a $(BUILD)/libglint.a

$(BUILD)/glint: $(CLI_OBJECTS) $(LIBRARIES)
	$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)

-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d)

# ---- Tests -----------------------------------------------------------------------------------------

# tests/<thing>/test_*.c, each a program of its own.
TEST_SOURCES  := $(wildcard tests/*/test_*.c)
TEST_PROGRAMS := $(TEST_SOURCES:%.c=$(BUILD)/%)
.SECONDARY: $(TEST_PROGRAMS:%=%.o)

# Circuits that are wrong on purpose, for the tests of the bench itself: gate cosine, pipelined, one
# lane. tests/lockstep/wrong/<what>/<module>.sed is the fault, an edit of rtl/<module>.v; one that no
# longer finds its line is an error. The test declares the table glint_wrong_<what>. Those of
# tests/lockstep/deep need a long run, or a long stall, to show.
FAULTS         := $(wildcard tests/lockstep/wrong/*/*.sed)
DEEP_FAULTS    := $(wildcard tests/lockstep/deep/*/*.sed)
wrong_name      = $(notdir $(patsubst %/,%,$(dir $1)))
WRONG_OBJECTS  := $(foreach f,$(FAULTS) $(DEEP_FAULTS),$(VERILATED)/wrong/$(call wrong_name,$f)/shim.o)

# $1: what, $2: the file of the fault, $3: the module's file name
define wrong_circuit
$(VERILATED)/wrong/$1/shim.o: $2 $(RTL) sim/rtl/specular_signals.vlt $(SHIM_SOURCES)
	@mkdir -p $$(@D)/rtl
	sed -f $2 rtl/$3 > $$(@D)/rtl/$3
	! cmp -s rtl/$3 $$(@D)/rtl/$3 || { echo "$2 changes nothing in rtl/$3"; exit 1; }
	$$(VERILATE) --prefix Vwrong_$1 --Mdir $$(@D) -I$$(@D)/rtl -Irtl \
	    sim/rtl/specular_signals.vlt specular_device.v
	$$(MAKE) -s -C $$(@D) -f Vwrong_$1.mk OPT_FAST=-O1 Vwrong_$1__ALL.a >/dev/null
	$$(CXX) $$(SHIM_FLAGS) -isystem $$(@D) -DMODEL=Vwrong_$1 -DGLINT_MODEL_TABLE=glint_wrong_$1 \
	    -DGLINT_MODEL_GATE=GLINT_GATE_COSINE -DGLINT_MODEL_PIPELINE=GLINT_PIPELINE_PIPELINED \
	    -DGLINT_MODEL_LANES=1 -DGLINT_MODEL_OBSERVED=true -c sim/rtl/model_shim.cpp -o $$@
endef
$(foreach f,$(FAULTS) $(DEEP_FAULTS),$(eval $(call wrong_circuit,$(call wrong_name,$f),$f,$(notdir $(f:.sed=.v)))))

# The same for the dividers, of twelve shifts: tests/divider/{wrong,deep}/<form>/<what>/<module>.sed, and
# the table glint_wrong_divider_<what>.
DIVIDER_FAULTS  := $(wildcard tests/divider/wrong/*/*/*.sed)
DEEP_DIVIDER_FAULTS := $(wildcard tests/divider/deep/*/*/*.sed)
wrong_form       = $(call wrong_name,$(patsubst %/,%,$(dir $1)))
WRONG_OBJECTS   += $(foreach f,$(DIVIDER_FAULTS) $(DEEP_DIVIDER_FAULTS),$(VERILATED)/wrong/divider_$(call wrong_name,$f)/shim.o)

# $1: divider_what, $2: the file of the fault, $3: the module's file name, $4: the form
define wrong_divider
$(VERILATED)/wrong/$1/shim.o: $2 $(RTL) sim/rtl/divider_signals.vlt $(DIVIDER_SHIM_SOURCES)
	@mkdir -p $$(@D)/rtl
	sed -f $2 rtl/$3 > $$(@D)/rtl/$3
	! cmp -s rtl/$3 $$(@D)/rtl/$3 || { echo "$2 changes nothing in rtl/$3"; exit 1; }
	$$(VERILATE_TOP) --prefix Vwrong_$1 --top $(call divider_top,$4) --Mdir $$(@D) \
	    -GSHIFTS=12 -I$$(@D)/rtl -Irtl sim/rtl/divider_signals.vlt $(call divider_top,$4).v
	$$(MAKE) -s -C $$(@D) -f Vwrong_$1.mk OPT_FAST=-O1 Vwrong_$1__ALL.a >/dev/null
	$$(CXX) $$(SHIM_FLAGS) -isystem $$(@D) -DMODEL=Vwrong_$1 -DGLINT_MODEL_TABLE=glint_wrong_$1 \
	    -DGLINT_MODEL_SHIFTS=12 $(if $(filter pipelined,$4),-DGLINT_MODEL_PIPELINED) \
	    -c sim/rtl/divider_shim.cpp -o $$@
endef
$(foreach f,$(DIVIDER_FAULTS) $(DEEP_DIVIDER_FAULTS),$(eval $(call wrong_divider,divider_$(call wrong_name,$f),$f,$(notdir \
    $(f:.sed=.v)),$(call wrong_form,$f))))

WRONG_ARCHIVES  := $(foreach o,$(WRONG_OBJECTS),$(dir $o)Vwrong_$(call wrong_name,$o)__ALL.a)

# What several tests share: tests/<thing>/*.c that are no programs themselves.
TEST_HELPERS := $(filter-out $(TEST_SOURCES) %/main.c %/drive.c,$(wildcard tests/*/*.c))
TEST_HELPER_OBJECTS := $(TEST_HELPERS:%.c=$(BUILD)/%.o)

$(BUILD)/libtest.a: $(TEST_HELPER_OBJECTS)
	rm -f $@
	ar rcs $@ $^

$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/libtest.a $(WRONG_OBJECTS) $(LIBRARIES)
	$(CXX) $(LDFLAGS) -o $@ $< $(BUILD)/libtest.a $(WRONG_OBJECTS) $(WRONG_ARCHIVES) $(LIBRARIES) \
	    -lcmocka $(LDLIBS)

# The command with a wrong circuit: what it says when C and Verilog differ. A wrong device is its only
# device; a wrong divider, found first, takes the place of the right one. $1: its directory, $2: the fault.
# WRONG says which the one in build/wrong has; those below it are for the tests.
WRONGS := $(foreach o,$(WRONG_OBJECTS),$(call wrong_name,$o))
WRONG  ?= truncating

define wrong_command
$1/rtl_models.h: $(BUILD)/rtl_models.h FORCE
	$(if $(filter $2,$(WRONGS)),,@echo "WRONG=$2: no such fault; there are $(sort $(WRONGS))" >&2; exit 1)
	@mkdir -p $$(@D)
	@$(if $(filter divider_%,$2),sed '/^#define GLINT_DIVIDER_MODELS/a\    X(glint_wrong_$2) \\' $$<,(cat $$<; \
	    echo "#undef GLINT_RTL_MODELS"; \
	    echo "#define GLINT_RTL_MODELS(X) X(glint_wrong_$2)")) > $$@.new
	@cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@

$1/rtl.o $1/divider_rtl.o: $1/%.o: sim/rtl/%.c $1/rtl_models.h
	$$(CC) -I$1 $$(CFLAGS_ALL) -c $$< -o $$@

$1/glint: $$(CLI_OBJECTS) $1/rtl.o $1/divider_rtl.o $$(WRONG_OBJECTS) $$(LIBRARIES)
	$$(CXX) $$(LDFLAGS) -o $$@ $$(CLI_OBJECTS) $1/rtl.o $1/divider_rtl.o \
	    $(VERILATED)/wrong/$2/shim.o $(VERILATED)/wrong/$2/Vwrong_$2__ALL.a $$(LIBRARIES) $$(LDLIBS)
endef
$(eval $(call wrong_command,$(BUILD)/wrong,$(WRONG)))
$(eval $(call wrong_command,$(BUILD)/wrong/divider,divider_table_off_by_one))
$(eval $(call wrong_command,$(BUILD)/wrong/silent,silent))
WRONG_COMMANDS := $(BUILD)/wrong/glint $(BUILD)/wrong/divider/glint $(BUILD)/wrong/silent/glint

build-tests: $(TEST_PROGRAMS) $(BUILD)/glint $(BUILD)/glint-gen $(WRONG_COMMANDS)
.PHONY: build-tests run-tests test-full

run-tests: build-tests
	GLINT=$(BUILD)/glint GLINT_BUILD=$(BUILD) tests/run.sh $(BUILD)/test-logs $(TEST_PROGRAMS)

test:
	sim/deps.sh test
	+$(MAKE) -j$(JOBS) build-tests
	+$(MAKE) run-tests

# The whole domain: every n and cosine code, every W that occurs with every colour, each gate and
# pipeline.
test-full: test
	$(BUILD)/glint verify --exhaustive --gate all --pipeline all

# The C code under AddressSanitizer and UBSan; the circuits are those of the plain build.
sanitize:
	sim/deps.sh test
	+$(MAKE) -j$(JOBS) SANITIZE=1 BUILD=$(BUILD)/sanitize VERILATED=$(VERILATED) build-tests
	+$(MAKE) SANITIZE=1 BUILD=$(BUILD)/sanitize VERILATED=$(VERILATED) run-tests

# ---- Lint ------------------------------------------------------------------------------------------

SETTINGS   := $(foreach g,0 1 2,$(foreach p,0 1,$g-$p))
C_SOURCES  := $(wildcard cmodel/*.c sim/*/*.c tests/*/*.c)
# $1: gate, $2: pipelined
yosys_check = read_verilog -Irtl $(wildcard rtl/*.v) ; \
              chparam -set GATE $1 -set PIPELINED $2 specular_device ; \
              hierarchy -check -top specular_device ; proc ; select -assert-none t:$$dlatch ; \
              synth -top specular_device ; check -assert
lint_setting = -GGATE=$(call field,$1,1) -GPIPELINED=$(call field,$1,2)

# The dividers' forms, by 6, 8, 12 and 16 shifts.
DIVIDER_SETTINGS := $(foreach f,sequential pipelined,$(foreach n,6 8 12 16,$f-$n))
# $1: top, $2: shifts
yosys_check_divider = read_verilog -Irtl $(wildcard rtl/*.v) ; chparam -set SHIFTS $2 $1 ; \
                      hierarchy -check -top $1 ; proc ; select -assert-none t:$$dlatch ; \
                      synth ; check -assert

.PHONY: lint-verilog lint-c $(SETTINGS:%=lint-%) $(DIVIDER_SETTINGS:%=lint-divider-%)
lint:
	sim/deps.sh lint
	+@mode=$$(stat -c %a /dev/null) && $(MAKE) -j$(JOBS) lint-verilog lint-c && \
	    { [ "$$(stat -c %a /dev/null)" = "$$mode" ] || \
	        { echo "lint has changed the mode of /dev/null from $$mode" >&2; exit 1; }; }

lint-verilog: $(SETTINGS:%=lint-%) $(DIVIDER_SETTINGS:%=lint-divider-%)

# What Icarus makes is not wanted, but goes to a file: it sets the mode of what it writes, and run by
# root on /dev/null it would take that away from everyone else.
LINTED = $(BUILD)/lint/$@.vvp

# Each gate and pipeline: Verilator with 1 and 16 lanes, Icarus, and Yosys down to gates, where a
# warning, a latch or a problem found by its checks is an error.
$(SETTINGS:%=lint-%): lint-%:
	@mkdir -p $(BUILD)/lint
	$(VERILATOR) --lint-only -Wall $(call lint_setting,$*) -GLANES=1 -Irtl rtl/specular_device.v
	$(VERILATOR) --lint-only -Wall $(call lint_setting,$*) -GLANES=16 -Irtl rtl/specular_device.v
	warnings=$$(iverilog -g2005 -Wall -Irtl -o $(LINTED) -s specular_device \
	    -Pspecular_device.GATE=$(call field,$*,1) -Pspecular_device.PIPELINED=$(call field,$*,2) \
	    $(wildcard rtl/*.v) 2>&1) && [ -z "$$warnings" ] || { echo "$$warnings"; exit 1; }
	yosys -q -e . -p '$(call yosys_check,$(call field,$*,1),$(call field,$*,2))'

$(DIVIDER_SETTINGS:%=lint-divider-%): lint-divider-%:
	@mkdir -p $(BUILD)/lint
	$(VERILATOR) --lint-only -Wall -GSHIFTS=$(call field,$*,2) -Irtl rtl/$(call divider_top,$*).v
	warnings=$$(iverilog -g2005 -Wall -Irtl -o $(LINTED) -s $(call divider_top,$*) \
	    -P$(call divider_top,$*).SHIFTS=$(call field,$*,2) $(wildcard rtl/*.v) 2>&1) && \
	    [ -z "$$warnings" ] || { echo "$$warnings"; exit 1; }
	yosys -q -e . -p '$(call yosys_check_divider,$(call divider_top,$*),$(call field,$*,2))'

# The other compiler: the build itself is with CC.
lint-c: $(BUILD)/rtl_models.h
	clang -std=c17 -O3 -fsyntax-only $(WARNINGS) -Icmodel -Isim -I$(BUILD) $(PACKAGE_CFLAGS) \
	    -isystem $(VERILATOR_ROOT_DIR)/include $(C_SOURCES)

# ---- Longer checks: mutation, proofs, netlists, coverage, fuzzing, each with its own rules ----------

include tests/circuits.mk $(wildcard tests/*/rules.mk)

# ---- What a user calls -----------------------------------------------------------------------------

demo:
	sim/deps.sh demo
	+$(MAKE) -j$(JOBS) $(BUILD)/glint
	@mkdir -p $(BUILD)/demo
	$(BUILD)/glint render --model teapot --size 1280x960 --backend both --out $(BUILD)/demo/teapot.png
	$(BUILD)/glint verify --clocks 20000
	$(BUILD)/glint wave --out $(BUILD)/demo
	@echo
	@echo "the picture:   $(BUILD)/demo/teapot.png"
	@echo "the waveform:  gtkwave $(BUILD)/demo/specular_cosine_pipelined.fst" \
	    "$(BUILD)/demo/specular_cosine_pipelined.gtkw"
	@command -v gtkwave >/dev/null || echo "(GTKWave is not installed; sim/deps.sh gtkwave installs it)"
	@echo "what it shows: docs/waveforms.md"

bench:
	sim/deps.sh bench
	+$(MAKE) -j$(JOBS) $(BUILD)/glint
	$(BUILD)/glint bench

wave:
	sim/deps.sh wave
	+$(MAKE) -j$(JOBS) $(BUILD)/glint
	$(BUILD)/glint wave --out $(BUILD)/wave

report:
	sim/deps.sh report
	+$(MAKE) -j$(JOBS) $(BUILD)/glint
	$(BUILD)/glint report --out $(BUILD)/report

# ---- Installing ------------------------------------------------------------------------------------

VERSION   := $(shell sed -n 's/.*GLINT_VERSION "\(.*\)"/\1/p' sim/cli/version.h)
SHARED    := $(BUILD)/libglint.so.$(VERSION)
INSTALLED := $(BUILD)/glint $(BUILD)/libglint.a $(SHARED) $(BUILD)/install/man/glint.1 \
             $(BUILD)/install/completion/glint.bash

$(BUILD)/pic/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_ALL) -fPIC -c $< -o $@

# Programs that were linked with one version run with every later one of the same first number.
$(SHARED): $(MODEL_SOURCES:%.c=$(BUILD)/pic/%.o)
	$(CC) $(LDFLAGS) -shared -Wl,-soname,libglint.so.$(firstword $(subst ., ,$(VERSION))) -o $@ $^ -lm

# Made of what the command's --help says.
$(BUILD)/install/man/glint.1: $(BUILD)/glint sim/install/man.sh
	sim/install/man.sh $(BUILD)/glint $(VERSION) @docdir@ $(@D)

$(BUILD)/install/completion/glint.bash: $(BUILD)/glint $(wildcard sim/install/*completion*) \
    sim/install/options.awk
	sim/install/completion.sh $(BUILD)/glint $(@D)

# A path with anything in it, for the shell. $1: the path
quoted = '$(subst ','\'',$1)'
PLACES = PREFIX=$(call quoted,$(PREFIX)) DESTDIR=$(call quoted,$(DESTDIR))

.PHONY: installable uninstall
installable: $(INSTALLED)
build-tests: installable

# sim/install/install.sh lists what goes where.
install:
	@$(PLACES) sim/install/install.sh check
	sim/deps.sh install
	+$(MAKE) -j$(JOBS) installable
	$(PLACES) sim/install/install.sh install $(BUILD) $(VERSION)

uninstall:
	$(PLACES) sim/install/install.sh uninstall $(BUILD) $(VERSION)

help:
	@echo "make demo      install what is missing, build, render the teapot by C and by Verilog, compare,"
	@echo "               verify, write waveforms, say where to look"
	@echo "make test      install what is missing, build, run every test"
	@echo "make test-full the same, and every input of the specular device, C against Verilog"
	@echo "make           build the command $(BUILD)/glint"
	@echo "make verification  all of it, and the table in docs/verification.md"
	@echo "make netlist   second opinions: synthesised netlists and other Verilator settings against the C model"
	@echo "make portability  the C model with musl, and on a big-endian machine by qemu"
	@echo "make reference the C model against exact rationals, every input"
	@echo "make formal    proofs over every sequence of inputs, by yosys-smtbmc and z3 (docs/formal.md)"
	@echo "make mutation  1000 single faults of each of four synthesised circuits: killed, or proven equivalent"
	@echo "make coverage  lines and toggles of rtl/, each covered or explained; the C by gcov"
	@echo "make bench     fragments, clocks and frames a second"
	@echo "make report    what the thesis claims, measured: $(BUILD)/report/index.html"
	@echo "make wave      the waveforms with their GTKWave save files"
	@echo "make lint      Verilator, Icarus, Yosys and both C compilers over everything"
	@echo "make sanitize  the tests under AddressSanitizer and UBSan"
	@echo "make fuzz      20 s of fuzzing (FUZZ_SECONDS=) for each reader of what comes from outside"
	@echo "make formats   16 to 20 fraction bits of the cosine, by one edit each (docs/formats.md)"
	@echo "make generate  write the generated Verilog anew from cmodel/"
	@echo "make install PREFIX=DIR   command, library, headers, Verilog, documentation ($(PREFIX)); DESTDIR= before it"
	@echo "make uninstall PREFIX=DIR what make install has put there"
	@echo "make clean     remove $(BUILD)/"
	@echo "Variables: BUILD=DIR, CC=, CXX=, JOBS=N, NO_INSTALL=1 (only say which packages are missing)"

clean:
	rm -rf $(BUILD)
