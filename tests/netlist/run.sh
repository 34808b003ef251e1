#!/bin/sh
# Runs the full list of second opinions, shows what it prints, and notes the results.
#
#   tests/netlist/run.sh PROGRAM LOG
#
# GLINT_NETLIST_CLOCKS: clocks for each circuit (200 000).
set -eu

program=$1 log=$2
export GLINT_NETLIST_CLOCKS="${GLINT_NETLIST_CLOCKS:-200000}"
begin=$(date +%s)
status=0
"$program" >"$log" 2>&1 || status=$?
cat "$log"
seconds=$(($(date +%s) - begin))

# The line "WHAT: M mismatches of N comparisons, …, C circuits, D differ", and a field of it.
sum_of() { # WHAT FIELD
    sed -n "s/^$1: //p" "$log" | awk -v field="$2" '{ print $field; found = 1 } END { exit !found }'
}

note() { # NAME WHAT METHOD CASES UNIT FAILED
    tests/verification/record.sh "$@" "$seconds" 'make netlist'
}

circuits=$(sum_of netlists 8)
note netlist-pins "Yosys netlists, iCE40 and plain gates, match the C model at the pins" \
    "lockstep of $circuits netlists" "$(sum_of netlists 4)" comparisons "$(sum_of netlists 1)"
circuits=$(sum_of 'second builds' 8)
note netlist-verilator "Verilator without its optimisers matches the C model in every register" \
    "lockstep of $circuits builds" "$(sum_of 'second builds' 4)" comparisons \
    "$(sum_of 'second builds' 1)"
circuits=$(sum_of 'wrong netlists' 8)
note netlist-faults "every faulty netlist is caught" "lockstep at the pins" "$circuits" faults \
    $((circuits - $(sum_of 'wrong netlists' 10)))
exit "$status"
