#!/bin/sh
# The proofs of all circuits, as tests/formal/prove.sh names them, one a line.
#
#   tests/formal/proofs.sh TABLE
#
# TABLE is build/settings; tests/formal/CIRCUIT.awk makes the proofs of a circuit's lines. Says on
# standard error which circuits have none.
set -eu
here=$(dirname "$0")

[ $# -eq 1 ] || {
    echo "tests/formal/proofs.sh: the table build/settings is needed" >&2
    exit 2
}
for circuit in $(cut -d ' ' -f 1 "$1" | uniq); do
    if [ -f "$here/$circuit.awk" ]; then
        awk -f "$here/$circuit.awk" "$1"
    else
        echo "formal: no proofs of circuit $circuit" >&2
    fi
done
