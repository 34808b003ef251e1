#!/bin/sh
# One proof of the circuits by yosys-smtbmc and z3, or one search that must find a fault.
#
#   tests/formal/prove.sh DIR PROOF                  proves PROOF of the circuits in rtl/
#   tests/formal/prove.sh DIR PROOF FAULT PROPERTY   edits rtl/ by FAULT, .../<module>.sed, and
#                                                    looks for a run that violates PROPERTY: there
#                                                    must be one
#
# PROOF  device-GATE-PIPELINE-LANES-LANE   gates-PIPELINE-LANES-LANE   roms   table-SHIFTS
#        sequential-SHIFTS   pipelined-SHIFTS
#        power-ACCURACY-PIPELINE-LANES-LANE   power_roms-ACCURACY
#        GATE cosine sign drawn; PIPELINE pipelined combinational; LANES 1 2 4 8 16, LANE the one
#        looked at; ACCURACY half quarter
#
# DIR gets the model (model.smt2), what the tools said (*.log), traces for GTKWave (*.vcd: one for
# each cover; counterexample.vcd where a property fails) and the line "result":
#   name, properties, method, seconds, covers reached of all ("-": none looked for), PROVED, FAULT
#   FOUND or FAILED and why; separated by tabs.
# A short form of it goes to standard output; where it is FAILED, the line itself to standard error.
# Exit status 0, 1 (FAILED) or 2 (not called as above, or a tool is missing).
#
# A proof with a clock is by induction over one clock: the assertions hold after a reset in any
# state whatever, and after any clock before which they held. Each property needs a cover reached,
# or the proof fails. See docs/formal.md.
set -eu
here=$(dirname "$0")
rtl=$here/../../rtl
limit=1800 # seconds for one run of the solver

usage() {
    echo "tests/formal/prove.sh: $*; see its head" >&2
    exit 2
}

[ $# -eq 2 ] || [ $# -eq 4 ] || usage "two or four arguments"
dir=$1
proof=$2
fault=${3:-}
wanted=${4:-}

number() {
    case $1 in
    '' | *[!0-9]*) usage "no proof \"$proof\"" ;;
    esac
}

# field N of the proof's name
field() {
    echo "$proof" | cut -s -d - -f "$1"
}

pipeline_number() {
    case $1 in
    combinational) echo 0 ;;
    pipelined) echo 1 ;;
    *) usage "no proof \"$proof\"" ;;
    esac
}

# The address bits of the power device's tables.
table_bits() {
    case $1 in
    half) echo 8 ;;
    quarter) echo 9 ;;
    *) usage "no proof \"$proof\"" ;;
    esac
}

device='specular_device specular_lane w_rounder color_multiplier stage_register'
flow='uninvited in_order once frozen'
clocked=yes
cut= # wires whose drivers are taken off
case $proof in
device-*)
    case $(field 2) in
    cosine) gate=0 ;;
    sign) gate=1 ;;
    drawn) gate=2 ;;
    *) usage "no proof \"$proof\"" ;;
    esac
    pipelined=$(pipeline_number "$(field 3)")
    number "$(field 4)"
    number "$(field 5)"
    top=device_proof modules=$device files='device flow formula lemma free_roms'
    parameters="-set GATE $gate -set PIPELINED $pipelined"
    parameters="$parameters -set LANES $(field 4) -set LANE $(field 5)"
    properties="$flow value" depth=12
    ;;
gates-*)
    pipelined=$(pipeline_number "$(field 2)")
    number "$(field 3)"
    number "$(field 4)"
    top=gates_proof modules=$device files='gates free_roms'
    cut='w:*.sum7 w:*.sum10 w:*.mul13 w:*.mul14 w:*.mul15'
    parameters="-set PIPELINED $pipelined -set LANES $(field 3) -set LANE $(field 4)"
    properties=gates_equal depth=8
    ;;
roms)
    top=roms_proof modules='sigma_rom limit_rom' files='roms formula lemma' parameters=
    properties='sigma range limit' clocked=no depth=1
    ;;
table-*)
    number "$(field 2)"
    top=table_proof modules=reciprocal_rom files=table parameters="-set SHIFTS $(field 2)"
    properties='rounded miss' clocked=no depth=1
    ;;
sequential-*)
    number "$(field 2)"
    top=shift_divider_proof modules='shift_divider reciprocal_rom' files=shift_divider
    parameters="-set SHIFTS $(field 2)"
    properties='busy done once sum out_of_table cleared frozen'
    depth=$(($(field 2) + 6))
    ;;
pipelined-*)
    number "$(field 2)"
    top=pipelined_divider_proof
    modules='pipelined_divider divider_stage stage_register reciprocal_rom'
    files='pipelined_divider flow' parameters="-set SHIFTS $(field 2)"
    properties="$flow sum out_of_table"
    depth=$((2 * $(field 2) + 6))
    ;;
power-*)
    bits=$(table_bits "$(field 2)")
    pipelined=$(pipeline_number "$(field 3)")
    number "$(field 4)"
    number "$(field 5)"
    top=power_proof
    modules='power_device power_lane material_path color_stage w_rounder color_multiplier'
    modules="$modules stage_register"
    files='power flow power_formula free_power_roms'
    parameters="-set TABLE_BITS $bits -set PIPELINED $pipelined"
    parameters="$parameters -set LANES $(field 4) -set LANE $(field 5)"
    properties="$flow value" depth=14
    ;;
power_roms-*)
    bits=$(table_bits "$(field 2)")
    top=power_roms_proof modules='power_log_rom power_exp_rom' files=power_roms
    parameters="-set TABLE_BITS $bits"
    properties='rising falling halves' clocked=no depth=1
    ;;
*) usage "no proof \"$proof\"" ;;
esac

for tool in yosys yosys-smtbmc z3; do
    command -v $tool >/dev/null || {
        echo "tests/formal/prove.sh: $tool not found: install yosys and z3 (make formal does)" >&2
        exit 2
    }
done

rm -rf "$dir"
mkdir -p "$dir"
begin=$(date +%s.%N)
method=
covers=-

# result TEXT: the line, and the end
result() {
    seconds=$(echo "$begin $(date +%s.%N)" | awk '{ printf "%.1f", $2 - $1 }')
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$proof${fault:+ $(basename "$(dirname "$fault")")}" \
        "${wanted:-$properties}" "$method" "$seconds" "$covers" "$1" >"$dir/result"
    case $1 in
    FAILED*)
        tr '\t' '|' <"$dir/result" >&2
        exit 1
        ;;
    esac
    awk -F '\t' '{ print $1 ": " $6 ($5 == "-" ? "" : ", " $5 " covers") ", " $4 " s" }' \
        "$dir/result"
    exit 0
}

if [ -n "$fault" ]; then
    module=$(basename "$fault" .sed)
    mkdir "$dir/rtl"
    cp "$rtl"/* "$dir/rtl"
    sed -f "$fault" "$rtl/$module.v" >"$dir/rtl/$module.v"
    ! cmp -s "$rtl/$module.v" "$dir/rtl/$module.v" ||
        result "FAILED: $fault changes nothing in rtl/$module.v"
    rtl=$dir/rtl
fi

# The model. Of a search for a fault only the wanted property's assertions stay.
script="read_verilog -formal -I$rtl"
for name in $modules; do script="$script $rtl/$name.v"; done
for name in $files; do script="$script $here/$name.v"; done
script="$script; ${parameters:+chparam $parameters $top;} prep -top $top -flatten;
    ${cut:+cutpoint $cut;} memory_map -rom-only;
    opt -keepdc -fast; dffunmap;"
[ -z "$wanted" ] || script="$script
    select -set wanted c:$wanted c:${wanted}_* c:*.$wanted c:*.${wanted}_*;
    delete t:\$assert @wanted %d; select -assert-min 1 t:\$assert;"
script="$script opt_clean; check -assert; write_smt2 -wires $dir/model.smt2"
yosys -q -p "$script" >"$dir/yosys.log" 2>&1 || result "FAILED: Yosys, see $dir/yosys.log"

# Labels of the model's cells of one kind: assert, cover.
labels() {
    sed -n "s/^; yosys-smt2-$1 [0-9]* //p" "$dir/model.smt2" | sed 's/.*\.//'
}

# smtbmc LOG ARGUMENT...: its exit status; its own solver is asked anew for each question
smtbmc() {
    log=$dir/$1.log
    shift
    timeout $limit yosys-smtbmc -s z3 --unroll --noprogress "$@" "$dir/model.smt2" >"$log" 2>&1
}
anew='--noincr --logic QF_BV'

if [ -n "$wanted" ]; then
    [ $clocked = yes ] && method="search, $depth clocks" || method='search, all inputs'
    # shellcheck disable=SC2086  # a list of words
    if smtbmc search $anew -t "$depth" --dump-vcd "$dir/counterexample.vcd"; then
        result "FAILED: fault not found"
    fi
    grep -q 'Assert failed' "$dir/search.log" || result "FAILED: see $dir/search.log"
    result 'FAULT FOUND'
fi

# Every assertion belongs to a property, or is a helper of the induction; every property has some.
for property in $properties; do
    labels assert | grep -q -e "^$property\(_.*\)\{0,1\}\$" ||
        result "FAILED: no assertion of $property"
done
labels assert | grep -v '^h_' | while read -r label; do
    for property in $properties; do
        case $label in
        "$property" | "$property"_*) continue 2 ;;
        esac
    done
    exit 1
done || result "FAILED: an assertion of no property"

# failed LOG: the assertions that the log says failed
failed() {
    failures=$(sed -n 's/.*Assert failed in [^:]*: //p' "$dir/$1.log" |
        sed 's/.*\.//' | tr '\n' ' ')
    result "FAILED: $1: ${failures:-see $dir/$1.log}"
}

if [ $clocked = no ]; then
    method='all inputs'
    # shellcheck disable=SC2086
    smtbmc inputs $anew -t 1 --dump-vcd "$dir/counterexample.vcd" || failed inputs
else
    method='induction, 1 clock'
    # shellcheck disable=SC2086
    smtbmc base $anew -t 2 --dump-vcd "$dir/counterexample.vcd" || failed base
    # shellcheck disable=SC2086
    smtbmc step $anew -i -t 1 --smtc "$here/step.smtc" --dump-vcd "$dir/counterexample.vcd" ||
        failed step
    grep -q 'Temporal induction successful' "$dir/step.log" || failed step
fi

# Each property's covers, in the smallest circuits that have it.
case $proof in
device-*-1-0 | gates-*-1-0 | roms | table-* | sequential-6 | sequential-12 | pipelined-6) ;;
power-*-1-0 | power_roms-*) ;;
*) result PROVED ;;
esac
all=$(labels cover | wc -l)
# shellcheck disable=SC2086
smtbmc cover $anew -c -t "$depth" --dump-vcd "$dir/cover%.vcd" || true
# The traces by name: smtbmc says what a trace reaches, then its file's name.
sed -n 's/.*Reached cover statement at \([^ ]*\) .*/reached \1/p;
        s/.*Writing trace to VCD file: \(.*\)/file \1/p' "$dir/cover.log" |
    while read -r kind name; do
        case $kind in
        reached) names="${names:-} ${name##*.}" ;;
        file)
            for label in $names; do
                cp "$name" "$dir/$label.vcd"
                echo "$label"
            done
            rm "$name"
            names=
            ;;
        esac
    done >"$dir/reached"
covers=$(wc -l <"$dir/reached")/$all
for property in $properties; do
    grep -q -e "^c_$property\(_.*\)\{0,1\}\$" "$dir/reached" ||
        result "FAILED: no cover of $property reached"
done
[ "$covers" = "$all/$all" ] || result "FAILED: a cover not reached, see $dir/cover.log"
result PROVED
