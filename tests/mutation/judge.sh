#!/bin/sh
# Judges what survived the bench, and adds everything up.
#
#   tests/mutation/judge.sh CIRCUIT DIR VERDICTS RESULTS SECONDS
#
# DIR is where mutants.sh wrote the netlist and the bench is, VERDICTS what the bench wrote. RESULTS
# takes the same table, with "survived" replaced by
#   equivalent  no inputs can show the fault; the column of the test says how that was proven
#   missed      the solver found inputs that show it, and the column has them: the bench has a hole
#   undecided   neither, within SECONDS
# and one line with the sums goes to standard output and to the table of all checks.
#
# The prover itself is asked about some faults that the bench killed, too. It must not call one of
# them equivalent, must find one of them different at least, and where it says by which point, the
# bench must see the fault at that point.
#
# Exit status 1 when a fault is missed or undecided; 2 when the prover fails its own test, or when
# there are no faults at all.
set -eu

fail() {
    echo "tests/mutation/judge.sh: $*" >&2
    exit 2
}

[ $# -eq 5 ] || fail "five arguments, not $#: CIRCUIT DIR VERDICTS RESULTS SECONDS"
circuit=$1 dir=$2 verdicts=$3 results=$4 seconds=$5
here=$(dirname "$0")
asked=10       # killed faults that the prover is asked about,
asked_limit=60 # for so many seconds an attempt
begin=$(date +%s)
trap 'rm -f "$results.new"' EXIT
trap 'exit 130' INT TERM

all=$(wc -l <"$verdicts")
[ "$all" -gt 0 ] || fail "$circuit: no faults"

progress() { # TEXT
    [ ! -t 2 ] || printf '\r\033[K%s' "$1" >&2
}

# ---- The prover on faults that can be seen -------------------------------------------------------

# Says how many of them were found different, and by how many points.
ask_about_killed() {
    different=0 points=0
    for mutant in $(awk -F '\t' -v asked=$asked '
        $2 == "killed" { killed[++n] = $1 }
        END { for (i = 1; i <= asked && i <= n; i++) print killed[int(i * n / asked + 0.5)] }' \
        "$verdicts" | sort -nu); do
        progress "$circuit: asking about killed fault $mutant"
        found=$("$here/prove.sh" "$dir" "$mutant" $asked_limit)
        case $found in
        equivalent*) fail "$circuit: the bench killed fault $mutant, which is \"$found\"" ;;
        different*n=*)
            different=$((different + 1)) points=$((points + 1))
            "$dir/bench" --list "$dir/mutants.list" --mutant "$mutant" \
                --point "${found#different?}" | grep -q "^$mutant	killed	point	" ||
                fail "$circuit: the bench does not see fault $mutant at \"$found\""
            ;;
        different*) different=$((different + 1)) ;;
        esac
    done
    [ "$different" -gt 0 ] ||
        fail "$circuit: the prover found none of $asked killed faults different"
    case $circuit in
    specular*) [ "$points" -gt 0 ] || fail "$circuit: no point shows any of $asked killed faults" ;;
    esac
}

# ---- The survivors -------------------------------------------------------------------------------

judge_survivors() {
    survivors=$(grep -c '	survived	' "$verdicts" || true)
    judged=0 longest=0
    while IFS='	' read -r mutant verdict rest; do
        if [ "$verdict" = survived ]; then
            judged=$((judged + 1))
            progress "$circuit: proof $judged of $survivors"
            started=$(date +%s)
            found=$("$here/prove.sh" "$dir" "$mutant" "$seconds")
            took=$(($(date +%s) - started))
            [ $took -le $longest ] || longest=$took
            case $found in
            equivalent*) verdict=$found ;;
            different*) verdict=missed${found#different} ;;
            *) verdict=undecided"	-" ;;
            esac
            rest=${rest#*	}
        fi
        printf '%s\t%s\t%s\n' "$mutant" "$verdict" "$rest"
    done <"$verdicts" >"$results.new"
    progress ''
    mv "$results.new" "$results"
}

count() { # VERDICT [HOW]
    awk -F '\t' -v verdict="$1" -v how="${2:-}" \
        '$2 == verdict && (how == "" || $3 == how) { n++ } END { print n + 0 }' "$results"
}

ask_about_killed
judge_survivors
open=$(($(count missed) + $(count undecided)))
score=$(awk -v killed="$(count killed)" -v of=$((all - $(count equivalent))) \
    'BEGIN { printf "%.2f", of ? 100 * killed / of : 0 }')
cat <<END
$circuit: $all faults: killed $(count killed) (lockstep $(count killed lockstep), \
sweep $(count killed sweep)), \
equivalent $(count equivalent) (induction $(count equivalent induction), \
reachability $(count equivalent reachability), points $(count equivalent points)), \
missed $(count missed), undecided $(count undecided); score $score % of those not proven equivalent
$circuit: the prover refuted $different of $asked killed faults, $points by a point that the bench \
confirms; the longest proof took $longest s of $seconds s an attempt
END
tests/verification/record.sh "mutation-$circuit" \
    "single faults of the synthesised $circuit are caught, or proven equivalent" \
    "Yosys mutate, lockstep, SAT" "$all" faults "$open" $(($(date +%s) - begin)) "make mutation"
[ "$open" -eq 0 ] || {
    grep -E '	(missed|undecided)	' "$results" | cut -c 1-160
    exit 1
}
