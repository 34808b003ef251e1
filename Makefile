# Glint: `make demo` and `make test` do everything; `make help` lists the rest.
#
# BUILD=DIR     where everything that is made goes (build)
# CC, CXX       the compilers (gcc, g++)
# SANITIZE=1    the C code with AddressSanitizer and UBSan (see the target sanitize)
# PREFIX=DIR    where make install puts things (/usr/local); DESTDIR=DIR: what stands before it
# NO_INSTALL=1  say which Debian packages are missing instead of installing them
# V=1           every command as it is run, instead of CC x.c

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
# For the makes that this one runs; `make -j2` counts for them as well.
PARALLEL   = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

# Quiet: `$Q` before a command, `$(call say,WHAT,FILE)` before that.
Q    := $(if $(V),,@)
say   = $(if $(V)$(SILENT),,@printf '  %-8s %s\n' $1 $2)

# Asked when they are first needed: by then $(BUILD)/packages has installed what was missing.
PACKAGES   := libpng freetype2 assimp jansson libcmark-gfm nettle
once        = $(eval $1 := $(shell $2))$($1)
PACKAGE_CFLAGS = $(call once,PACKAGE_CFLAGS,pkg-config --cflags $(PACKAGES) 2>/dev/null)
PACKAGE_LIBS   = $(call once,PACKAGE_LIBS,pkg-config --libs $(PACKAGES) 2>/dev/null)
WARNINGS   := -Wall -Wextra -Wpedantic -Wconversion -Werror
# Compiling is most of the wait for a first picture, so only what a loop over points, pixels or
# clocks spends its time in is optimised: VECTOR what gains by vectors, HOT what is called for
# each; the rest runs once a command and is compiled at -O0. Tests are computations of their own.
VECTOR     := $(addprefix sim/,bench/kernels bench/formulas lockstep/exhaustive lockstep/domain \
              rtl/specular_batch rtl/divider_batch rtl/span_batch $(addprefix render/,approximate \
              points raster reflection_map shade)) \
              cmodel/specular_batch cmodel/power_batch cmodel/unit_batch
HOT        := cmodel/ $(addprefix sim/,backend/ bench/ circuit/random circuit/schedule \
              circuit/stimulus circuit/divider_stimulus circuit/units color/ compare/errors \
              energy/ image/ lockstep/ reflectance/ rtl/needed rtl/rtl thread/ trace/ \
              $(addprefix render/,camera clip detail gouraud listing mesh paint pick quadratic \
              render scene setup sheen show span split transform)) tests/reference/
among       = $(filter $(addsuffix %,$1),$<)
OPTIMIZE    = $(if $(call among,$(VECTOR)),$(if $(SANITIZE),-O1,-O3),\
              $(if $(call among,$(HOT)),$(if $(SANITIZE),-O1,-O2),\
              $(if $(filter tests/%,$<),$(if $(SANITIZE),-O0,-O1),-O0)))
# No contraction: a frame has the same bits on every machine. -g1: lines, not variables; CFLAGS=-g
# for those.
CFLAGS_ALL  = -std=c17 $(OPTIMIZE) -g1 -ffp-contract=off -fno-math-errno $(WARNINGS) -MMD -MP \
              -Icmodel -Isim -I$(BUILD) $(PACKAGE_CFLAGS) $(CFLAGS)
LDLIBS      = $(PACKAGE_LIBS) -lz -lm -lpthread -ldl

ifdef SANITIZE
CFLAGS_ALL += -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
LDFLAGS    += -fsanitize=address,undefined
endif

.DELETE_ON_ERROR:
.PHONY: all demo test bench wave report lint clean help install generate build-all sanitize

all: $(BUILD)/glint

# Checks once that everything a build needs is installed; all compilation waits for it.
$(BUILD)/packages: sim/deps.sh
	$Qsim/deps.sh build
	@mkdir -p $(@D)
	@touch $@

# ---- The C model: libglint, and the generator of what rtl/ includes --------------------

MODEL_SOURCES := $(filter-out cmodel/gen.c,$(wildcard cmodel/*.c))
MODEL_OBJECTS := $(MODEL_SOURCES:%.c=$(BUILD)/%.o)

$(BUILD)/%.o: %.c | $(BUILD)/packages
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$Q$(CC) $(CFLAGS_ALL) -c $< -o $@

$(BUILD)/libglint.a: $(MODEL_OBJECTS)
	$(call say,AR,$@)
	@rm -f $@
	$Qar rcs $@ $^

$(BUILD)/glint-gen: $(BUILD)/cmodel/gen.o $(BUILD)/libglint.a
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ -lm

# Generated files are committed; `make generate` regenerates them, and a test compares. A file that
# stays the same is not touched.
GENERATED := rtl/glint_formats.vh:formats rtl/sigma_rom.v:sigma-rom rtl/limit_rom.v:limit-rom \
             rtl/reciprocal_rom.v:reciprocal-rom rtl/power_log_rom.v:power-log-rom \
             rtl/power_exp_rom.v:power-exp-rom cmodel/power_tables.h:power-tables \
             rtl/newton_rom.v:newton-rom rtl/log2_base_rom.v:log2-base-rom \
             rtl/log2_slope_rom.v:log2-slope-rom rtl/quadratic_rom.v:quadratic-rom \
             rtl/bipartite_value_rom.v:bipartite-value-rom \
             rtl/bipartite_offset_rom.v:bipartite-offset-rom \
             cmodel/rival_tables.h:rival-tables

.PHONY: generate-verilog
generate: generate-verilog drawings
generate-verilog: $(BUILD)/glint-gen
	@for pair in $(GENERATED); do \
	    file=$${pair%%:*}; \
	    $(BUILD)/glint-gen $(BUILD)/generated $${pair##*:} || exit 1; \
	    cmp -s $(BUILD)/generated $$file || \
	        { cp $(BUILD)/generated $$file && echo "$$file is new"; } || exit 1; \
	done; \
	rm $(BUILD)/generated

# The circuits' drawings: a line each in docs/images/drawings.txt.
.PHONY: drawings
drawings: $(BUILD)/glint
	$Qsim/deps.sh draw
	$Qsim/draw/drawings.sh $<

# ---- What drives them: libglint-sim and the command ----------------------------------------------

SIM_SOURCES := $(filter-out $(wildcard sim/cli/*.c) sim/compare/main.c,$(wildcard sim/*/*.c))
SIM_OBJECTS := $(SIM_SOURCES:%.c=$(BUILD)/%.o)
CLI_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(wildcard sim/cli/*.c))


# Text that a program prints: a file's lines as C strings, to be included in an array.
$(BUILD)/%.inc: %
	@mkdir -p $(@D)
	$Qsed 's/[\\"]/\\&/g; s/.*/"&",/' $< > $@

DRAWINGS := specular.svg specular-drawn.svg divider-sequential.svg
TEXTS    := $(patsubst %,$(BUILD)/%.inc,$(wildcard sim/report/text/*) $(DRAWINGS:%=docs/images/%) \
              docs/compare.csv)
$(BUILD)/sim/report/texts.o: $(TEXTS)
SHADERS  := $(patsubst %,$(BUILD)/%.inc,$(wildcard sim/shader/*))
$(BUILD)/sim/gl/texts.o: $(SHADERS)

# Loops whose speed is measured; see the file.
$(BUILD)/sim/bench/formulas.o: CFLAGS_ALL += -ffast-math

$(BUILD)/libglint-sim.a: $(SIM_OBJECTS)
	$(call say,AR,$@)
	@rm -f $@
	$Qar rcs $@ $^

LIBRARIES = $(BUILD)/libglint-sim.a $(BUILD)/libglint.a

# By this link a program that was built here finds rtl/ and sim/rtl/shim.cpp: it builds the circuits
# that it needs, and keeps them in $(BUILD)/circuits (sim/rtl/place.h).
$(BUILD)/tree: | $(BUILD)/packages
	@ln -sfnr . $@

$(BUILD)/glint: $(CLI_OBJECTS) $(LIBRARIES) | $(BUILD)/tree
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# What the demo's picture and verdict need of it, two thirds: main.c goes without the others.
LATER          := $(wildcard $(addprefix sim/,bench/*.c compare/*.c convert/*.c draw/*.c \
                    energy/*.c gl/*.c report/*.c study/*.c)) \
                  $(filter-out %/names.c,$(wildcard sim/trace/*.c)) \
                  $(addprefix sim/,image/png_read.c image/text.c lockstep/exhaustive.c \
                    reflectance/accuracy.c render/table21.c)
LATER_OF_CLI   := $(addprefix sim/cli/,cmd_%.c eval_%.c exhaustive_options.c input.c number_list.c \
                    render_gl.c verify_domain.c)
FIRST_COMMANDS := render verify wave
FIRST_SOURCES  := $(filter-out $(LATER),$(SIM_SOURCES)) $(FIRST_COMMANDS:%=sim/cli/cmd_%.c) \
                  $(filter-out $(LATER_OF_CLI),$(wildcard sim/cli/*.c))
$(BUILD)/glint-first: $(FIRST_SOURCES:%.c=$(BUILD)/%.o) $(BUILD)/libglint.a | $(BUILD)/tree
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# Not by way of $(BUILD)/tree, and no directories: caches of circuits have some of that ending.
-include $(foreach d,$(filter-out $(BUILD)/tree/%,$(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d)),\
             $(if $(wildcard $d/.),,$d))

# ---- Tests ---------------------------------------------------------------------------------------

# tests/<thing>/test_*.c, each a program of its own.
TEST_SOURCES  := $(wildcard tests/*/test_*.c)
TEST_PROGRAMS := $(TEST_SOURCES:%.c=$(BUILD)/%)
.SECONDARY: $(TEST_PROGRAMS:%=%.o)

# Circuits that are wrong on purpose, for the tests of the bench itself: $(BUILD)/wrong/<what> is
# rtl/ with a fault in it, for the option --rtl. The fault is an edit of rtl/<module>.v; one that no
# longer finds its line is an error. Those of deep/ need a long run, or a long stall, to show.
RTL             := $(wildcard rtl/*.v rtl/*.vh)
FAULTS          := $(wildcard tests/lockstep/wrong/*/*.sed)
DEEP_FAULTS     := $(wildcard tests/lockstep/deep/*/*.sed)
# Of the dividers: tests/divider/{wrong,deep}/<form>/<what>/<module>.sed,
# $(BUILD)/wrong/divider_<what>.
DIVIDER_FAULTS  := $(wildcard tests/divider/wrong/*/*/*.sed)
DEEP_DIVIDER_FAULTS := $(wildcard tests/divider/deep/*/*/*.sed)
# Of the power device: tests/power/wrong/<what>/<module>.sed, $(BUILD)/wrong/power_<what>.
POWER_FAULTS    := $(wildcard tests/power/wrong/*/*.sed)
# Of the span unit: tests/span/wrong/<what>/<module>.sed, $(BUILD)/wrong/span_<what>.
SPAN_FAULTS     := $(wildcard tests/span/wrong/*/*.sed)
wrong_name       = $(notdir $(patsubst %/,%,$(dir $1)))

# $1: what, $2: the file of the fault, $3: the module's file name
define wrong_circuit
WRONG_CIRCUITS += $(BUILD)/wrong/$1/$3
$(BUILD)/wrong/$1/$3: $2 $(RTL)
	$$(call say,SED,$$@)
	@rm -rf $$(@D) && mkdir -p $$(@D)
	@cp $(RTL) $$(@D)
	$$Qsed -f $2 rtl/$3 > $$@
	@! cmp -s rtl/$3 $$@ || { echo "$2 changes nothing in rtl/$3" >&2; exit 1; }
endef
$(foreach f,$(FAULTS) $(DEEP_FAULTS),\
    $(eval $(call wrong_circuit,$(call wrong_name,$f),$f,$(notdir $(f:.sed=.v)))))
$(foreach f,$(DIVIDER_FAULTS) $(DEEP_DIVIDER_FAULTS),\
    $(eval $(call wrong_circuit,divider_$(call wrong_name,$f),$f,$(notdir $(f:.sed=.v)))))
$(foreach f,$(POWER_FAULTS),\
    $(eval $(call wrong_circuit,power_$(call wrong_name,$f),$f,$(notdir $(f:.sed=.v)))))
$(foreach f,$(SPAN_FAULTS),\
    $(eval $(call wrong_circuit,span_$(call wrong_name,$f),$f,$(notdir $(f:.sed=.v)))))

# Shared by several tests: tests/<thing>/*.c that are not programs themselves.
TEST_HELPERS := $(filter-out $(TEST_SOURCES) %/main.c %/drive.c,$(wildcard tests/*/*.c))
TEST_HELPER_OBJECTS := $(TEST_HELPERS:%.c=$(BUILD)/%.o)

$(BUILD)/libtest.a: $(TEST_HELPER_OBJECTS)
	$(call say,AR,$@)
	@rm -f $@
	$Qar rcs $@ $^

$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/libtest.a $(LIBRARIES) | $(BUILD)/tree
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -o $@ $< $(BUILD)/libtest.a $(LIBRARIES) -lcmocka $(LDLIBS)

# Those that take longest start first, so that in the end no processor waits for one of them.
TESTS_LONG := $(addprefix $(BUILD)/tests/,planted/test_planted_signals formats/test_formats \
                lockstep/test_backends \
                circuit/test_own_circuit netlist/test_opinions cli/test_cmd_divide \
                cli/test_wrong_circuit circuit/test_build cli/test_cmd_report_whole \
                cli/test_cmd_bench formal/test_formal model/test_accuracy)
long_first  = $(filter $1,$(TESTS_LONG)) $(filter-out $(TESTS_LONG),$1)
# What runs no C code of ours, but scripts, make, solvers and other simulators, or code that is
# compiled anew without the sanitizers, or (test_blind) no command where one is expected: not again
# under these. What C there is in the tests themselves is a list of calls.
TESTS_OF_TOOLS := $(addprefix $(BUILD)/tests/,coverage/test_coverage_report deps/test_deps \
                    formal/test_formal formats/test_formats harness/test_blind make/test_make \
                    portability/test_portability verification/test_table verilog/test_icarus)
TESTS_RUN = $(if $(SANITIZE),$(filter-out $(TESTS_OF_TOOLS),$(TEST_PROGRAMS)),$(TEST_PROGRAMS))

build-tests: $(TESTS_RUN) $(BUILD)/glint $(BUILD)/glint-first $(BUILD)/glint-gen $(WRONG_CIRCUITS)
.PHONY: build-tests run-tests test-full

run-tests: build-tests
	GLINT=$(BUILD)/glint GLINT_BUILD=$(BUILD) JOBS=$(JOBS) \
	    tests/run.sh $(BUILD)/test-logs $(call long_first,$(TESTS_RUN))

# For the edit loop: the C model, the descriptions, and one setting of each circuit in lockstep. No
# GTKWave, clang or valgrind. One test alone: make build/tests/model/test_device &&
# build/tests/model/test_device
CHECKS := $(filter %/test_description %/test_words %/test_random_pins $(BUILD)/tests/model/% \
          $(BUILD)/tests/image/% $(BUILD)/tests/color/%,$(TEST_PROGRAMS))
.PHONY: check
check:
	@sim/deps.sh check
	@+$(MAKE) --no-print-directory $(PARALLEL) $(CHECKS) $(BUILD)/glint $(BUILD)/glint-gen
	@$(BUILD)/glint verify --clocks 20000 --lanes 1 --gate cosine --pipeline pipelined \
	    --seed 1 --out $(BUILD)/check
	@$(BUILD)/glint verify --clocks 20000 --circuit divider --shifts 12 --seed 1 --out $(BUILD)/check
	@GLINT=$(BUILD)/glint GLINT_BUILD=$(BUILD) JOBS=$(JOBS) \
	    tests/run.sh $(BUILD)/check-logs $(call long_first,$(CHECKS))

# The circuits that most tests need are built first, together.
test:
	sim/deps.sh test
	+$(MAKE) $(PARALLEL) build-tests
	$(BUILD)/glint verify --clocks 1000 --seed 1 --out $(BUILD)/test-failure
	+$(MAKE) run-tests

# The whole domain: every n and cosine code, every W that occurs with every colour, each gate and
# pipeline; and the batches of every setting as built for speed.
test-full: test
	GLINT_EVERY_SETTING=1 $(BUILD)/tests/lockstep/test_backends
	$(BUILD)/glint verify --exhaustive --gate all --pipeline all

# The C code under AddressSanitizer and UBSan, but for TESTS_OF_TOOLS; the circuits are those of the
# plain build.
sanitize: export GLINT_CACHE := $(abspath $(BUILD))/circuits
sanitize:
	sim/deps.sh test
	+$(MAKE) $(PARALLEL) SANITIZE=1 BUILD=$(BUILD)/sanitize VERILATED=$(VERILATED) build-tests
	+$(MAKE) SANITIZE=1 BUILD=$(BUILD)/sanitize VERILATED=$(VERILATED) run-tests

# ---- Lint ----------------------------------------------------------------------------------------

C_SOURCES  := $(wildcard cmodel/*.c sim/*/*.c tests/*/*.c \
                         docs/examples/*/*.c tests/circuit/own/*/*.c)

.PHONY: lint-verilog lint-c lint-cpp
lint:
	sim/deps.sh lint
	+@mode=$$(stat -c %a /dev/null) && \
	    $(MAKE) $(PARALLEL) lint-verilog lint-c lint-cpp lint-shaders lint-style lint-tidy && \
	    { [ "$$(stat -c %a /dev/null)" = "$$mode" ] || \
	        { echo "lint has changed the mode of /dev/null from $$mode" >&2; exit 1; }; }

# Every listed setting of every circuit; make lint-NAME for one of them, as $(BUILD)/settings has
# it. By Yosys, which takes longest, all settings of a top together: make lint-gates-TOP.
lint-verilog: $(BUILD)/settings
	+@$(MAKE) $$(cut -d ' ' -f 3 $< | sort -u | sed 's/^/lint-gates-/') \
	    $$(cut -d ' ' -f 2 $< | sed 's/^/lint-/')

lint-gates-%: $(BUILD)/settings FORCE
	$(call say,LINT,'$* as gates')
	$Qtests/circuits/lint_gates.sh $* $< $(BUILD)/lint

lint-%: $(BUILD)/settings FORCE
	$(call say,LINT,$*)
	$Qtests/circuits/lint.sh $* $< $(BUILD)/lint

# The other compiler: the build itself is with CC.
lint-c: $(TEXTS) $(SHADERS)
	$(call say,LINT,'$(words $(C_SOURCES)) C files')
	$Qclang -std=c17 -O3 -fsyntax-only $(WARNINGS) -Icmodel -Isim -I$(BUILD) \
	    $(PACKAGE_CFLAGS) $(C_SOURCES)

# The shim over a circuit, with and without a clock and a waveform; in use it is compiled without
# warnings, because Verilator's code is not ours to fix.
lint-cpp:
	$(call say,LINT,sim/rtl/shim.cpp)
	@mkdir -p $(BUILD)/lint/shim
	$Qtests/circuits/lint_shim.sh $(BUILD)/lint/shim $(VERILATOR_INCLUDE)

# ---- Longer checks: mutation, proofs, netlists, coverage, fuzzing, each with its own rules -------

include tests/circuits.mk $(wildcard tests/*/rules.mk)

# ---- What a user calls ---------------------------------------------------------------------------

# As soon as may be: the picture and a first verdict, by a command that is not whole yet, each with
# the one circuit that it shows; then the waveform, while the rest of the command is compiled.
DEMO := $(BUILD)/demo
.PHONY: demo-picture demo-verdict demo-wave
demo:
	@sim/deps.sh demo
	@echo "building $(BUILD)/glint"
	@+$(MAKE) --no-print-directory $(PARALLEL) SILENT=1 $(BUILD)/glint-first
	@mkdir -p $(DEMO)
	@echo "building two circuits from the Verilog: one draws the picture, one shows every register"
	@+$(MAKE) --no-print-directory $(if $(PARALLEL),-j2) -Otarget demo-picture demo-verdict
	@+$(MAKE) --no-print-directory $(PARALLEL) SILENT=1 demo-wave $(BUILD)/glint
	@echo
	@echo "the picture:   $(DEMO)/teapot.png"
	@echo "the waveform:  gtkwave $(DEMO)/specular_cosine_pipelined.fst" \
	    "$(DEMO)/specular_cosine_pipelined.gtkw"
	@command -v gtkwave >/dev/null || \
	    echo "(GTKWave is not installed; sim/deps.sh gtkwave installs it)"
	@echo "what it shows: docs/waveforms.md"
	@echo "every setting: $(BUILD)/glint verify (builds the other 51 circuits)"
	@echo "how to work:   docs/working.md"

demo-picture:
	@$(BUILD)/glint-first render --model teapot --size 1280x960 --backend both --lanes 4 --force \
	    --out $(DEMO)/teapot.png

demo-verdict:
	@$(BUILD)/glint-first verify --clocks 20000 --lanes 1 --gate cosine --pipeline pipelined \
	    --seed 1 --out $(DEMO)/failure

demo-wave:
	@$(BUILD)/glint-first wave --lanes 1 --pipeline pipelined --circuit specular --out $(DEMO) \
	    >/dev/null

bench:
	sim/deps.sh bench
	+$(MAKE) $(PARALLEL) $(BUILD)/glint
	$(BUILD)/glint bench

wave:
	sim/deps.sh wave
	+$(MAKE) $(PARALLEL) $(BUILD)/glint
	$(BUILD)/glint wave --out $(BUILD)/wave

report:
	sim/deps.sh report
	+$(MAKE) $(PARALLEL) $(BUILD)/glint
	$(BUILD)/glint report --out $(BUILD)/report

# ---- Installing ----------------------------------------------------------------------------------

VERSION   := $(shell sed -n 's/.*GLINT_VERSION "\(.*\)"/\1/p' sim/cli/version.h)
SHARED    := $(BUILD)/libglint.so.$(VERSION)
INSTALLED := $(BUILD)/glint $(BUILD)/libglint.a $(SHARED) $(BUILD)/install/man/glint.1 \
             $(BUILD)/install/completion/glint.bash

$(BUILD)/pic/%.o: %.c | $(BUILD)/packages
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$Q$(CC) $(CFLAGS_ALL) -fPIC -c $< -o $@

# Programs that were linked with one version run with every later one of the same first number.
$(SHARED): $(MODEL_SOURCES:%.c=$(BUILD)/pic/%.o)
	$(call say,LD,$@)
	$Q$(CC) $(LDFLAGS) -shared -Wl,-soname,libglint.so.$(firstword $(subst ., ,$(VERSION))) \
	    -o $@ $^ -lm

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
	+$(MAKE) $(PARALLEL) installable
	$(PLACES) sim/install/install.sh install $(BUILD) $(VERSION)

uninstall:
	$(PLACES) sim/install/install.sh uninstall $(BUILD) $(VERSION)

help:
	@echo "make demo      install what is missing, build, render the teapot with C and with Verilog,"
	@echo "               compare, verify, write waveforms, say where to look"
	@echo "make test      install what is missing, build, run every test"
	@echo "make test-full the same, plus every input of the specular device, C against Verilog"
	@echo "make check     a light test for the edit loop, well under a minute (docs/working.md)"
	@echo "make           build the command $(BUILD)/glint"
	@echo "make verification  all of it, and the table in docs/verified.md"
	@echo "make netlist   second opinions: netlists and other Verilator settings against the C model"
	@echo "make portability  the C model with musl, and on a big-endian machine by qemu"
	@echo "make reference the C model against exact rationals, every input"
	@echo "make newest    a shorter pass with the newest Verilator of the package index for Python"
	@echo "make compare   the highlight units: errors, sizes, clock rates (docs/compare.md)"
	@echo "make formal    proofs over all input sequences, with yosys-smtbmc and z3 (docs/formal.md)"
	@echo "make mutation  1000 single faults in each of 4 netlists: killed or proven equivalent"
	@echo "make coverage  lines and toggles of rtl/, each covered or explained; the C by gcov"
	@echo "make bench     fragments, clocks and frames a second"
	@echo "make report    what the thesis claims, measured: $(BUILD)/report/index.html"
	@echo "make wave      the waveforms with their GTKWave save files"
	@echo "make lint      Verilator, Icarus, Yosys, both C compilers, glslang, clang-tidy, the style"
	@echo "make sanitize  the tests under AddressSanitizer and UBSan"
	@echo "make fuzz      20 s of fuzzing (FUZZ_SECONDS=) for each reader of what comes from outside"
	@echo "make formats   16 to 20 fraction bits of the cosine, by one edit each (docs/formats.md)"
	@echo "make generate  write the generated Verilog (from cmodel/) and drawings anew"
	@echo "make install [PREFIX=$(PREFIX)] [DESTDIR=]  command, library, headers, Verilog, docs"
	@echo "make uninstall [PREFIX=] [DESTDIR=]  remove what make install put there"
	@echo "make clean     remove $(BUILD)/"
	@echo "Variables: BUILD=DIR, CC=, CXX=, JOBS=N, NO_INSTALL=1 (only say which packages are missing)"

clean:
	rm -rf $(BUILD)
