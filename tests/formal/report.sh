#!/bin/sh
# The table of what tests/formal/prove.sh found, from its directories, and a note of each group for
# docs/verified.md.
#
#   tests/formal/report.sh DIRECTORY...
#
# Exit status 1 when one failed or is missing, 2 when none is given.
set -eu
here=$(dirname "$0")

[ $# -gt 0 ] || {
    echo "tests/formal/report.sh: no proofs" >&2
    exit 2
}

lines=$(
    for dir in "$@"; do
        if [ -s "$dir/result" ]; then
            cat "$dir/result"
        else
            printf '%s\t-\t-\t0\t-\tFAILED: not run\n' "$(basename "$dir")"
        fi
    done
)

printf 'proof\tproperties\tmethod\tseconds\tcovers\tresult\n%s\n' "$lines" |
    awk -F '\t' '
        {
            for (i = 1; i <= 6; i++) {
                cell[NR, i] = $i
                if (length($i) > width[i]) width[i] = length($i)
            }
        }
        END {
            for (n = 1; n <= NR; n++) {
                for (i = 1; i < 6; i++) printf "%-" width[i] "s  ", cell[n, i]
                print cell[n, 6]
            }
        }'

# record NAME WHAT METHOD PATTERN RESULT UNIT: of the lines whose name matches
record() {
    chosen=$(echo "$lines" | grep -e "$4" | grep -e "	\($5\|FAILED.*\)\$") || return 0
    # shellcheck disable=SC2046  # three words
    set -- "$@" $(echo "$chosen" | awk -F '\t' '
        { seconds += $4 } /\tFAILED/ { failed++ } END { print NR, failed + 0, seconds }')
    "$here/../verification/record.sh" "$1" "$2" "$3" "$7" "$6" "$8" "$9" 'make formal'
}

record formal-device \
    'every input comes out once, in order, on time, with its value; freeze and reset work' \
    'induction, z3' '^device-[^ ]*	' PROVED proofs
record formal-divider 'busy, done, latency; the sum of the terms of the table' \
    'induction, z3' '^\(sequential\|pipelined\|table\)-[^ ]*	' PROVED proofs
record formal-gates 'gates sign and cosine are equal' 'induction, z3' '^gates-[^ ]*	' PROVED proofs
record formal-power 'the power device: order, time, value, freeze, reset; its ROMs are monotone' \
    'induction, z3' '^power\(_roms\)\{0,1\}-[^ ]*	' PROVED proofs
record formal-roms 'ROM 33 is (n+1)/3 rounded; ROM 9 is where t changes sign' 'SMT, z3' \
    '^roms	' PROVED proofs
record formal-wrong 'every deliberately broken circuit is caught' 'counterexample, z3' \
    '^[^ 	]* ' 'FAULT FOUND' circuits

echo "$lines" | awk -F '\t' '
    $6 == "PROVED" { proved++ } $6 == "FAULT FOUND" { found++ }
    $6 ~ /^FAILED/ { failed++ }
    { seconds += $4; if (split($5, c, "/") == 2) covers += c[1] }
    END {
        printf "%d proved, %d wrong circuits noticed, %d failed; %d covers reached; %d s of work\n",
            proved, found, failed, covers, seconds
        exit failed > 0 || proved == 0 || found == 0
    }'
