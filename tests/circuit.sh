#!/bin/sh
# One more form of a circuit: DIR/rtl, a directory with its Verilog, and DIR/tools, a link to the
# directory with verilator and c++, with which sim/rtl is to build it (VERILATOR, CXX). It is shared
# by all circuits of one BUILD, so that Verilator's runtime is compiled once for them.
#
#   tests/circuit.sh BUILD[-WRONG]/SETTING TABLE WRONGS DIR
#
# SETTING  one of the table that tests/circuits/main.c prints
# BUILD    ice40, dsp  the netlist that Yosys makes of it for the iCE40, with LUTs alone or with its
#                      multipliers too, and Yosys's models of the cells: the top has no parameters
#          generic     the netlist of simple gates
#          nodfg       the Verilog, Verilated with -fno-dfg: without the optimiser of data flow
#          plain       the same with -O0: without any
#          coverage    the same with counters of lines and toggles (sim/rtl/shim.cpp says where each
#                      instance leaves them)
# WRONG    takes the Verilog of WRONGS/WRONG, a circuit that is wrong on purpose, instead of rtl/
#
# Run it from the directory that holds rtl/.
set -eu

fail() {
    echo "tests/circuit.sh: $*" >&2
    exit 2
}

[ $# -eq 4 ] || fail "four arguments, not $#: BUILD[-WRONG]/SETTING TABLE WRONGS DIR"
build=${1%%/*} setting=${1#*/} table=$2 wrongs=$3 dir=$4
rtl=rtl
case $build in *-*) rtl=$wrongs/${build#*-} build=${build%%-*} ;; esac

line=$(awk -v setting="$setting" '$2 == setting' "$table")
[ -n "$line" ] || fail "there is no setting \"$setting\" in $table"
top=$(echo "$line" | cut -d ' ' -f 3)
parameters=$(echo "$line" | cut -s -d ' ' -f 5-)

tools=$(dirname "$(dirname "$dir")")/tools/$build
rm -rf "$dir"
mkdir -p "$dir" "$tools"
cp -r "$rtl" "$dir/rtl"
ln -s "../../tools/$build" "$dir/tools"

synthesise() { # COMMAND OF YOSYS
    set_all=
    for parameter in $parameters; do
        set_all="$set_all -set ${parameter%=*} ${parameter#*=}"
    done
    # A vector becomes a wire for each bit: Verilator looks for loops vector by vector, and would
    # see one where low bits lead to high ones.
    yosys -q -p "
        read_verilog -I$dir/rtl $dir/rtl/*.v
        chparam $set_all $top
        hierarchy -check -top $top
        rename -top $top
        $1 -top $top
        check -assert
        splitnets
        write_verilog -noattr -noexpr $dir/netlist.v"
}

# The netlist takes the place of all the Verilog, with what comes before it. Of cells, Yosys's own
# models have a time scale, and the rest of what is built has none.
replace() { # FILE OF CELLS
    rm "$dir"/rtl/*
    {
        # Yosys's model of the multiplier SB_MAC16 has constants of 32 bits for parameters of one,
        # and adds and shifts words of 16 and 24 bits where 32 are wanted; each is widened with
        # zeros, as is meant. Verilator 5.006 has no default values of ports; a port left open is an
        # error here. The names of a netlist are of no interest, and too much for a waveform.
        printf '/* verilator lint_off WIDTH */\n/* verilator tracing_off */\n'
        printf '%sdefine NO_ICE40_DEFAULT_ASSIGNMENTS\n' '`'
        sed '/^`timescale/d' "$1"
        printf '/* verilator lint_on WIDTH */\n'
        cat "$dir/netlist.v"
    } >"$dir/rtl/$top.v"
    rm "$dir/netlist.v"
}

# With FLAGS when one of the WORDs is among the arguments. Several makes may come here at once.
tool() { # NAME COMMAND FLAGS WORD...
    tool=$tools/$1 command=$2 flags=$3
    shift 3
    {
        echo '#!/bin/sh'
        echo "# Written by tests/circuit.sh: $command with more flags, and a version of its own."
        echo "case \" \$* \" in"
        echo "*' --version '*) echo \"\$($command \"\$@\" | head -n 1) $flags\" ;;"
        for word in "$@"; do
            echo "*' $word '*) exec $command \"\$@\" $flags ;;"
        done
        echo "*) exec $command \"\$@\" ;;"
        echo esac
    } >"$tool.$$"
    chmod +x "$tool.$$"
    if cmp -s "$tool.$$" "$tool"; then rm "$tool.$$"; else mv "$tool.$$" "$tool"; fi
}

# Yosys looks for its models of cells in the same place.
cells=$(dirname "$(command -v yosys)")/../share/yosys
flags= counting=
case $build in
ice40 | dsp)
    synthesise "synth_ice40$([ "$build" = ice40 ] || echo ' -dsp')"
    replace "$cells/ice40/cells_sim.v"
    ;;
generic)
    synthesise 'synth -flatten'
    replace "$cells/simcells.v"
    ;;
nodfg) flags=-fno-dfg ;;
plain) flags=-O0 ;;
coverage)
    flags='--coverage-line --coverage-toggle --coverage-max-width 1024'
    counting='-UVM_COVERAGE -DVM_COVERAGE=1'
    ;;
*) fail "unknown build \"$build\"" ;;
esac
# Without an optimisation of trees of AND, OR and XOR: with it Verilator 5.006 gets two of the
# netlists wrong (docs/netlists.md).
case $build in ice40 | dsp | generic) flags=-fno-const-bit-op-tree ;; esac
tool verilator "${VERILATOR:-verilator}" "$flags" --cc --lint-only
tool c++ "${CXX:-g++}" "$counting" -c -shared c++-header
