#!/bin/sh
# Lint of sim/rtl/shim.cpp, by both compilers, over a circuit that is Verilated with and without a
# waveform: where it runs it is compiled without warnings, as Verilator's code is nobody's to mend.
#
#   tests/circuits/lint_shim.sh DIR INCLUDE
#
# DIR is for what Verilator writes, INCLUDE Verilator's own directory of headers. To be called from the
# directory that holds rtl/ and sim/.
set -eu

dir=$1 include=$2
for traced in '' --trace-fst; do
    made=$dir/circuit$traced
    rm -rf "$made"
    mkdir -p "$made"
    # shellcheck disable=SC2086  # nothing, or a word
    "${VERILATOR:-verilator}" --cc $traced --prefix Vcircuit --Mdir "$made" -Irtl rtl/shift_divider.v
    {
        echo '#define GLINT_PORTS(X) X("done", done) X("quotient", quotient)'
        echo '#define GLINT_CLOCK clk'
        [ -z "$traced" ] || echo '#define GLINT_TRACED'
    } >"$made/glint_ports.h"
    for compiler in g++ clang++; do
        $compiler -std=gnu++17 -fsyntax-only -Wall -Wextra -Werror -Isim/rtl -isystem "$made" \
            -isystem "$include" -isystem "$include/vltstd" -DVM_COVERAGE=0 sim/rtl/shim.cpp
    done
done
