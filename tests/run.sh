#!/bin/sh
# Runs test programs (cmocka), one after the other, and adds up what they report.
#
#   tests/run.sh LOGDIR PROGRAM...
#
# A line for each program; the whole log of one that fails, and of each skipped test why. The last
# line counts the tests of all; exit status 1 when one failed or when no test ran at all.
set -u

logs=$1
shift
mkdir -p "$logs"
passed=0
failed=0
skipped=0

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

for program in "$@"; do
    name=${program##*/}
    log=$logs/$name.log
    begin=$(date +%s)
    "$program" >"$log" 2>&1
    status=$?
    good=$(count_of PASSED "$log")
    bad=$(count_of FAILED "$log")
    left=$(count_of SKIPPED "$log")
    if [ "$status" -ne 0 ] || [ "$bad" -ne 0 ] || [ "$((good + left))" -eq 0 ]; then
        [ "$bad" -ne 0 ] || bad=1 # it crashed, or ran no test
        cat "$log"
        echo "FAILED  $name (exit status $status); run it again: $program"
    else
        printf 'ok      %-28s %3d tests, %d s\n' "$name" "$good" "$(($(date +%s) - begin))"
        reasons "$log"
    fi
    passed=$((passed + good))
    failed=$((failed + bad))
    skipped=$((skipped + left))
done

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
