#!/bin/sh
# Runs test programs (cmocka), one for each processor at once, and adds up what they report.
#
#   tests/run.sh LOGDIR PROGRAM...
#
# Programs start in the given order, so list the slowest first. JOBS=1 runs them one after the
# other.
#
# A line for each program as it ends; the whole log of one that fails, and of each skipped test why.
# Then, of more than ten, the ten that took longest. The last line counts the tests of all. Exit
# status 1 when one failed or when no test ran at all.
set -u

# The number in cmocka's closing line "[  PASSED  ] N test(s).", "[  FAILED  ] N test(s)…" or
# "[  SKIPPED ] N test(s)…".
count_of() {
    count=$(sed -n "s/^\[  $1  *\] \([0-9][0-9]*\) test(s).*/\1/p" "$2" | tail -n 1)
    echo "${count:-0}"
}

# What a test said before it was skipped, which is why.
reasons() {
    awk '/^\[ RUN/ { said = ""; next }
         /^\[  SKIPPED \] [^0-9]/ { if (!seen[$NF]++) print "        skipped " $NF ": " said; next }
         { said = $0 }' "$1"
}

# Runs one program and stores its counts next to its log: PASSED FAILED SKIPPED SECONDS NAME. Two
# of the same name, in different directories, must not share these files.
run() {
    logs=$1 program=$2
    name=${program##*/}
    files=$logs/$(printf '%s' "$program" | tr / -)
    log=$files.log
    begin=$(date +%s)
    "$program" >"$log" 2>&1
    status=$?
    seconds=$(($(date +%s) - begin))
    good=$(count_of PASSED "$log")
    bad=$(count_of FAILED "$log")
    left=$(count_of SKIPPED "$log")
    if [ "$status" -ne 0 ] || [ "$bad" -ne 0 ] || [ "$((good + left))" -eq 0 ]; then
        [ "$bad" -ne 0 ] || bad=1 # it crashed, or ran no test
        said=$(cat "$log" && echo "FAILED  $name (exit status $status); run it again: $program")
    else
        said=$(printf 'ok      %-28s %3d tests, %d s\n' "$name" "$good" "$seconds" &&
            reasons "$log")
    fi
    echo "$good $bad $left $seconds $name" >"$files.count"
    printf '%s\n' "$said" # at once, so that two do not mix
}

if [ "$1" = --one ]; then
    run "$2" "$3"
    exit 0
fi

logs=$1
shift
mkdir -p "$logs"
rm -f "$logs"/*.count
printf '%s\n' "$@" | xargs -d '\n' -n 1 -P "${JOBS:-$(nproc)}" "$0" --one "$logs"

if [ $# -gt 10 ]; then
    echo 'the longest:'
    cat "$logs"/*.count | sort -k4,4nr | head -n 10 | awk '{ printf "%5d s  %s\n", $4, $5 }'
fi
# A program that left no count was ended from outside, with the script about it.
cat "$logs"/*.count | awk -v programs=$# '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        failed += programs - NR
        printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
        exit failed != 0 || passed == 0
    }'
