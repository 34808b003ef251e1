#!/bin/sh
# Lint of a top's Verilog by Yosys, down to gates: a warning, a latch or a problem found by its
# checks is an error.
#
#   tests/circuits/lint_gates.sh TOP TABLE DIR
#
# All settings of TABLE (build/settings) with that top stand side by side in one design, in DIR: a
# module that several of them share (a lane, a ROM) is synthesised once. Modules stay apart, so it
# does not matter that nothing is connected to the settings. The gates are not optimised (-noabc),
# which would find nothing. To be called from the directory that holds rtl/. Exit status 1 when
# something is found.
set -eu

top=$1 table=$2 dir=$3
mkdir -p "$dir"
design=$dir/every_$top.v

awk -v top="$top" '
    BEGIN { print "module every_setting;" }
    $3 == top {
        list = ""
        for (i = 5; i <= NF; i++) {
            split($i, parameter, "=")
            list = list (list == "" ? "" : ", ") "." parameter[1] "(" parameter[2] ")"
        }
        print "    (* keep *) " top (list == "" ? "" : " #(" list ")") " " $2 " ();"
        settings++
    }
    END { print "endmodule"; exit settings == 0 }' "$table" >"$design" || {
    echo "tests/circuits/lint_gates.sh: no setting in $table has the top \"$top\"" >&2
    exit 2
}

# The last line: each setting is still there, with gates in it.
yosys -q -e . -p "
    read_verilog -Irtl rtl/*.v $design
    hierarchy -check -top every_setting
    proc
    select -assert-none t:\$dlatch
    synth -noabc
    check -assert
    select -assert-count $(grep -c keep "$design") every_setting/c:*"
