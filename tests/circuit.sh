#!/bin/sh
# One more build of a circuit, beside those of the Makefile: DIR/shim.o with the table TABLE, and
# DIR/circuit.a.
#
#   tests/circuit.sh BUILD[-FAULT]:CIRCUIT TABLE DIR
#
# CIRCUIT  gate-pipeline-lanes of the specular device, or form-shifts of a divider
# BUILD    ice40, dsp  the netlist that Yosys makes of it for the iCE40, with LUTs alone or with its
#                      multipliers too, and Yosys's models of the cells
#          generic     the netlist of simple gates
#          nodfg       the Verilog, Verilated with -fno-dfg: without the optimiser of data flow
#          plain       the same with -O0: without any
#          coverage    the same with counters of lines and toggles; each instance writes them to a
#                      file of its own in the directory GLINT_COVERAGE as it goes
# FAULT    a fault of tests/*/wrong, put into the Verilog first
#
# To be called from the directory that holds rtl/, by make, which gives the commands VERILATE,
# COMPILE and MAKE.
set -eu

fail() {
    echo "tests/circuit.sh: $*" >&2
    exit 2
}

number_of() { # NAME CHOICE...: the place of NAME among the choices, from 0
    name=$1 place=0
    shift
    for choice in "$@"; do
        [ "$choice" != "$name" ] || { echo "$place" && return; }
        place=$((place + 1))
    done
    fail "\"$name\" is none of: $*"
}

[ $# -eq 3 ] || fail "three arguments, not $#: BUILD[-FAULT]:CIRCUIT TABLE DIR"
build=${1%:*} circuit=${1#*:} table=$2 dir=$3
fault=${build#*-} build=${build%%-*}
[ "$fault" != "$build" ] || fault=
class=V$table

first=${circuit%%-*} rest=${circuit#*-}
second=${rest%%-*} third=${rest##*-}
case $first in
sequential | pipelined)
    top=$([ "$first" = sequential ] && echo shift_divider || echo pipelined_divider)
    parameters="SHIFTS=$second"
    signals=sim/rtl/divider_signals.vlt
    shim=divider_shim.cpp
    settings="-DGLINT_MODEL_SHIFTS=$second"
    [ "$first" = sequential ] || settings="$settings -DGLINT_MODEL_PIPELINED"
    ;;
*)
    top=specular_device
    gate=$(number_of "$first" cosine sign drawn)
    pipeline=$(number_of "$second" combinational pipelined)
    parameters="GATE=$gate PIPELINED=$pipeline LANES=$third"
    signals=sim/rtl/specular_signals.vlt
    shim=model_shim.cpp
    settings="-DGLINT_MODEL_GATE=(glint_gate)$gate -DGLINT_MODEL_PIPELINE=(glint_pipeline)$pipeline
              -DGLINT_MODEL_LANES=$third"
    ;;
esac

rm -rf "$dir"
mkdir -p "$dir"
rtl=rtl
if [ -n "$fault" ]; then
    rtl=$dir/rtl
    cp -r rtl "$rtl"
    for edit in tests/*/wrong/"$fault"/*.sed tests/*/wrong/*/"$fault"/*.sed; do
        [ -e "$edit" ] || continue
        module=$(basename "$edit" .sed).v
        sed -f "$edit" "rtl/$module" >"$rtl/$module"
        cmp -s "rtl/$module" "$rtl/$module" && fail "$edit changes nothing in rtl/$module"
    done
    diff -rq rtl "$rtl" >/dev/null && fail "there is no fault \"$fault\""
fi

synthesise() { # COMMAND OF YOSYS
    set_all=
    for parameter in $parameters; do
        set_all="$set_all -set ${parameter%=*} ${parameter#*=}"
    done
    # A vector becomes a wire for each bit: Verilator looks for loops vector by vector, and would see
    # one where low bits lead to high ones.
    yosys -q -p "
        read_verilog -I$rtl $rtl/*.v
        chparam $set_all $top
        hierarchy -check -top $top
        rename -top $top
        $1 -top $top
        check -assert
        splitnets
        write_verilog -noattr -noexpr $dir/netlist.v"
}

# Yosys looks for its models of cells in the same place.
cells=$(dirname "$(command -v yosys)")/../share/yosys
verilog="-I$rtl $rtl/$top.v"
for parameter in $parameters; do
    verilog="-G$parameter $verilog"
done
observed=true
case $build in
ice40 | dsp | generic)
    observed=false
    signals=tests/netlist/pins.vlt
    # The models of cells have a time scale, so the netlist needs one. Without an optimisation of trees
    # of AND, OR and XOR: with it Verilator 5.006 gets two of the netlists wrong (docs/netlists.md).
    verilog="-fno-const-bit-op-tree --timescale 1ps/1ps $dir/netlist.v"
    ;;
esac
case $build in
ice40 | dsp)
    synthesise "synth_ice40$([ "$build" = ice40 ] || echo ' -dsp')"
    # Verilator 5.006 has no default values of ports; a port left open is an error here.
    verilog="-DNO_ICE40_DEFAULT_ASSIGNMENTS $cells/ice40/cells_sim.v $verilog"
    ;;
generic)
    synthesise 'synth -flatten'
    verilog="$cells/simcells.v $verilog"
    ;;
nodfg) verilog="-fno-dfg $verilog" ;;
plain) verilog="-O0 $verilog" ;;
coverage)
    verilog="--coverage-line --coverage-toggle --coverage-max-width 1024 $verilog"
    settings="$settings -UVM_COVERAGE -DVM_COVERAGE=1 -DGLINT_COUNTING_TABLE=$table
              -DGLINT_COUNTING_NAME=$circuit"
    table=${table}_plain
    ;;
*) fail "unknown build \"$build\"" ;;
esac
shim_of_build=sim/rtl/$shim
[ "$build" != coverage ] || shim_of_build=tests/coverage/$shim

# shellcheck disable=SC2086  # lists of words
{
    $VERILATE --top "$top" --prefix "$class" --Mdir "$dir/verilated" $signals $verilog
    # One file and no optimisation: to compile is what takes the time here.
    $MAKE -s -C "$dir/verilated" -f "$class.mk" VM_PARALLEL_BUILDS=0 OPT_FAST=-O0 OPT_SLOW=-O0 \
        "${class}__ALL.a" >/dev/null
    $COMPILE -isystem "$dir/verilated" "-DMODEL=$class" "-DGLINT_MODEL_TABLE=$table" $settings \
        "-DGLINT_MODEL_OBSERVED=$observed" -c "$shim_of_build" -o "$dir/shim.o"
}
mv "$dir/verilated/${class}__ALL.a" "$dir/circuit.a"
