#!/bin/sh
# One definition changed by one edit: does all that follows from it follow?
#
#   tests/formats/try.sh DIR NAME VALUE SETTING...
#
# Copies the sources into DIR (made anew), sets NAME in cmodel/glint_formats.h to VALUE, generates
# what is generated, looks at the Verilog with Verilator's lint, builds the C model and what drives
# circuits, and runs tests/formats/drive.c with the settings (cosine-pipelined-4). With $GLINT_CACHE
# the circuits, and Verilator's own runtime, are kept there. Exit status 0 when everything builds
# and nothing differs.
set -eu

scratch=$1
name=$2
value=$3
shift 3
formats=cmodel/glint_formats.h

# An outer make's job server and variables are not for the one below.
unset MAKEFLAGS MFLAGS MAKELEVEL BUILD VERILATED SANITIZE

rm -rf "$scratch"
mkdir -p "$scratch"
cp -rp Makefile cmodel rtl sim tests "$scratch"
# What the edit leaves as it is need not be compiled again.
if [ -d build/sim ]; then
    mkdir "$scratch/build"
    cp -rp build/packages build/cmodel build/sim "$scratch/build"
fi
cd "$scratch"

[ "$(grep -c "^#define $name  *[0-9][0-9]*\$" $formats)" -eq 1 ] ||
    { echo "$formats: no line gives $name a number" >&2; exit 2; }
sed -i "s/^\(#define $name  *\)[0-9][0-9]*\$/\1$value/" $formats

# Prints output only on failure.
quietly() {
    "$@" >log 2>&1 || { cat log; echo "failed with $name $value: $*"; exit 1; }
}

quietly make generate-verilog
for gate in 0 1 2; do
    quietly verilator --lint-only -Wall -GGATE=$gate -GLANES=16 -Irtl rtl/specular_device.v
done
quietly make -j"$(nproc)" build/tests/formats/drive
build/tests/formats/drive "$@"
