#!/bin/sh
# Lint of one setting's Verilog by Verilator and Icarus, where a warning is an error; Yosys looks at
# all settings together (lint_gates.sh).
#
#   tests/circuits/lint.sh SETTING TABLE DIR
#
# SETTING is one of TABLE (build/settings); DIR is for what Icarus makes. Run it from the directory
# that holds rtl/. Exit status 1 when something is found.
set -eu

setting=$1 table=$2 dir=$3
line=$(awk -v setting="$setting" '$2 == setting' "$table")
[ -n "$line" ] || {
    echo "tests/circuits/lint.sh: there is no setting \"$setting\" in $table" >&2
    exit 2
}
top=$(echo "$line" | cut -d ' ' -f 3)
verilator= icarus=
for parameter in $(echo "$line" | cut -s -d ' ' -f 5-); do
    verilator="$verilator -G$parameter"
    icarus="$icarus -P$top.$parameter"
done
mkdir -p "$dir"

# shellcheck disable=SC2086  # lists of words
"${VERILATOR:-verilator}" --lint-only -Wall $verilator -Irtl "rtl/$top.v"

# What Icarus makes is not wanted, but goes to a file: it sets the mode of what it writes, and run
# by root on /dev/null it would take that away from everyone else.
# shellcheck disable=SC2086
warnings=$(iverilog -g2005 -Wall -Irtl -o "$dir/$setting.vvp" -s "$top" $icarus rtl/*.v 2>&1) &&
    [ -z "$warnings" ] || { echo "$warnings" && exit 1; }
rm -f "$dir/$setting.vvp"
