#!/bin/sh
# The two tables of docs/mutation.md: the outcome of all faults, and the faults proven equivalent.
#
#   tests/mutation/tables.sh DIR CIRCUIT...
#
# DIR/CIRCUIT is where judge.sh wrote results.tsv. In the second table faults of the same kind share
# a row: the kind of cell (a register with its name in the Verilog), its pin, what the fault does
# there, how it was proven.
set -eu

fail() {
    echo "tests/mutation/tables.sh: $*" >&2
    exit 2
}

[ $# -ge 2 ] || fail "DIR CIRCUIT..., not $# arguments"
dir=$1
shift
for circuit in "$@"; do
    for file in healthy.il results.tsv; do
        [ -f "$dir/$circuit/$file" ] || fail "no $dir/$circuit/$file; run make mutation"
    done
done

printf '%s\n' \
    "| circuit | faults | killed | by lockstep | by the sweep | equivalent | missed or undecided \
| killed of those not equivalent |" \
    '|---|---|---|---|---|---|---|---|'
for circuit in "$@"; do
    awk -F '\t' -v circuit="$circuit" '
        { n[$2]++; n[$2, $3]++ }
        END {
            different = NR - n["equivalent"]
            printf "| `%s` | %d | %d | %d | %d | %d | %d | %.2f %% |\n", circuit, NR, n["killed"],
                n["killed", "lockstep"], n["killed", "sweep"], n["equivalent"],
                n["missed"] + n["undecided"], different ? 100 * n["killed"] / different : 0
        }' "$dir/$circuit/results.tsv"
done

printf '%s\n' '' '| circuit | cell | pin | fault | proof | how many |' '|---|---|---|---|---|---|'
for circuit in "$@"; do
    awk -v circuit="$circuit" '
        BEGIN {
            fault_of["const0"] = "stuck at 0"
            fault_of["const1"] = "stuck at 1"
            fault_of["inv"] = "inverted"
        }
        FILENAME ~ /healthy\.il$/ {
            if ($1 == "cell") {
                cell = $3
                kind[cell] = substr($2, 3, length($2) - 3)
            } else if ($1 == "connect" && $2 == "\\Q") {
                name = $3
                sub(/^\\/, "", name)
                kind[cell] = "register `" name "`"
            }
            next
        }
        /\tequivalent\t/ {
            split($0, field, "\t")
            for (i = 1; i < NF; i++)
                given[$i] = $(i + 1)
            fault = fault_of[given["-mode"]]
            count[kind[given["-cell"]] " | " given["-port"] " | " fault " | " field[3]]++
        }
        END {
            for (row in count)
                print "| `" circuit "` | " row " | " count[row] " |"
        }' "$dir/$circuit/healthy.il" "$dir/$circuit/results.tsv" | LC_ALL=C sort
done
