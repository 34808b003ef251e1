#!/bin/sh
# Lint of sim/rtl/shim.cpp, by both compilers, over a circuit that is Verilated with waveforms of
# either kind, and without but with counters; and with the loop over points, specular_batch.cpp,
# over narrow and wide ports: where it runs it is compiled without warnings, as
# Verilator's code is not ours to fix.
#
#   tests/circuits/lint_shim.sh DIR INCLUDE
#
# DIR is for what Verilator writes, INCLUDE Verilator's own directory of headers. Run it from the
# directory that holds rtl/ and sim/.
set -eu

dir=$1 include=$2
for traced in '' --trace-fst --trace; do
    made=$dir/circuit$traced
    [ -z "$traced" ] && counting=1 || counting=0
    rm -rf "$made"
    mkdir -p "$made"
    # shellcheck disable=SC2086  # nothing, or a word
    "${VERILATOR:-verilator}" --cc $traced --prefix Vcircuit --Mdir "$made" \
        -Irtl rtl/shift_divider.v
    {
        echo '#define GLINT_PORTS(X) X("done", done) X("quotient", quotient)'
        echo '#define GLINT_CLOCK clk'
        [ "$traced" != --trace-fst ] || echo '#define GLINT_FST'
        [ "$traced" != --trace ] || echo '#define GLINT_VCD'
    } >"$made/glint_ports.h"
    for compiler in g++ clang++; do
        $compiler -std=gnu++17 -fsyntax-only -Wall -Wextra -Werror -Isim/rtl -isystem "$made" \
            -isystem "$include" -isystem "$include/vltstd" -DVM_COVERAGE="$counting" \
            sim/rtl/shim.cpp
    done
done
for lanes in 1 16; do
    made=$dir/points-$lanes
    rm -rf "$made"
    mkdir -p "$made"
    "${VERILATOR:-verilator}" --cc --prefix Vcircuit --Mdir "$made" -GLANES=$lanes \
        -Irtl rtl/specular_device.v
    {
        echo '#define GLINT_PORTS(X) X("out_w", out_w)'
        echo '#define GLINT_CLOCK clk'
        echo "#define GLINT_SHADE_LANES $lanes"
        echo '#define GLINT_SHADE_W_BITS 19'
        echo '#define GLINT_SHADE_COS_BITS 19'
        echo '#define GLINT_SHADE_LATENCY 4'
    } >"$made/glint_ports.h"
    for compiler in g++ clang++; do
        $compiler -std=gnu++17 -fsyntax-only -Wall -Wextra -Werror -Isim/rtl -isystem "$made" \
            -isystem "$include" -isystem "$include/vltstd" -DVM_COVERAGE=0 \
            -include sim/rtl/shim.cpp -x c++ sim/rtl/specular_batch.cpp
    done
done
