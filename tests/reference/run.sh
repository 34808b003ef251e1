#!/bin/sh
# The C model against the exact rational reference over the whole domain, and the notes of it.
#
#   tests/reference/run.sh PROGRAM LOG
set -eu

program=$1 log=$2
begin=$(date +%s)
status=0
GLINT_REFERENCE_STEP=1 "$program" >"$log" 2>&1 || status=$?
cat "$log"
seconds=$(($(date +%s) - begin))

note() { # NAME WHAT LINE UNIT: of the line "LINE: D differ of N UNIT…"
    counts=$(sed -n "s/^$3: \([0-9]*\) differ of \([0-9]*\).*/\2 \1/p" "$log")
    [ -n "$counts" ] || return 0 # the test before it failed, and so does this
    tests/verification/record.sh "$1" "$2" 'exact rationals, whole domain' "${counts% *}" "$4" \
        "${counts#* }" "$seconds" 'make reference'
}
note model-reference-w 'W is the formula with its stated rounding, bit for bit' W points
note model-reference-colors 'each output is W times the colour, rounded to nearest, bit for bit' \
    colours values
note model-reference-multiplier 'multiplier 13 rounds every product to nearest' \
    'multiplier 13' pairs
note model-reference-roms 'both ROMs match their definitions' ROMs words
note model-reference-divider 'each quotient is exactly the sum of the terms of the rounded 1/k' \
    divider divisions
exit "$status"
