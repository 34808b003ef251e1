#!/bin/sh
# Runs libFuzzer's programs, one after the other, and says what each did.
#
#   tests/fuzz/run.sh BUILD SECONDS TARGET...
#
# Programs are BUILD/fuzzers/TARGET. They start from tests/fuzz/corpus/TARGET and what earlier runs
# found (BUILD/corpus/TARGET, grows). An input that fails is kept as BUILD/failures/TARGET-…; the
# exit status is 1 then, and when a target did nothing; 2 when it is called otherwise. GLINT_SEED=
# repeats a run's choices.
set -u

fail() {
    echo "tests/fuzz/run.sh: $*" >&2
    exit 2
}

[ $# -ge 3 ] || fail "at least three arguments, not $#: BUILD SECONDS TARGET..."
build=$1
seconds=$2
shift 2
# libFuzzer treats 0 and non-numbers as no limit at all.
case $seconds in
'' | 0* | *[!0-9]*) fail "SECONDS \"$seconds\" is no whole number above 0" ;;
esac
seed=${GLINT_SEED:-$(date +%s)}
mkdir -p "$build/failures" "$build/logs"
status=0
echo "seed $seed (the same again: GLINT_SEED=$seed), $seconds s each"

# The number that libFuzzer's closing statistics give for a name.
statistic() {
    sed -n "s/^stat::$1: *\([0-9]*\)$/\1/p" "$log" | tail -n 1
}

for target in "$@"; do
    log=$build/logs/$target.log
    kept=$build/corpus/$target
    mkdir -p "$kept"
    begin=$(date +%s)
    ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 "$build/fuzzers/$target" \
        -seed="$seed" -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=3000 \
        -print_final_stats=1 -artifact_prefix="$build/failures/$target-" \
        "$kept" "tests/fuzz/corpus/$target" >"$log" 2>&1
    ended=$?
    tried=$(statistic number_of_executed_units)
    tried=${tried:-0}
    covered=$(sed -n 's/^#.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
    failed=0
    if [ "$ended" -ne 0 ] || [ "$tried" -eq 0 ]; then
        failed=1
        status=1
        tail -n 40 "$log"
    fi
    printf '%-7s %9d inputs, %5d code edges, %5d inputs kept, %d failures\n' "$target" "$tried" \
        "${covered:-0}" "$(find "$kept" -type f | wc -l)" "$failed"
    sed -n 's/^mesh: /        /p' "$log"
    [ "$tried" -eq 0 ] || tests/verification/record.sh "fuzz-$target" \
        "no input to the target \"$target\" crashes it, hangs it or violates an invariant" \
        "libFuzzer, ASan, UBSan" \
        "$tried" inputs "$failed" "$(($(date +%s) - begin))" "make fuzz FUZZ_SECONDS=$seconds"
done
exit "$status"
