#!/bin/sh
# A circuit's synthesised netlist, and many single faults of it in one Verilog file.
#
#   tests/mutation/mutants.sh SETTING TABLE COUNT SEED DIR
#
# SETTING  one of TABLE, which tests/circuits/main.c prints
# COUNT    how many faults, chosen by Yosys's mutate from SEED
#
# Writes to DIR: healthy.il, the netlist in Yosys's own format; mutants.list, the faults, a command
# of Yosys a line; mutants.v, the netlist with all of them and two inputs more: a rising edge of
# "choose" switches on the fault whose line is the number on "fault", and with 0 none. Run it from
# the directory that holds rtl/.
set -eu

fail() {
    echo "tests/mutation/mutants.sh: $*" >&2
    exit 2
}

[ $# -eq 5 ] || fail "five arguments, not $#: SETTING TABLE COUNT SEED DIR"
circuit=$1 table=$2 count=$3 seed=$4 dir=$5

line=$(awk -v setting="$circuit" '$2 == setting' "$table")
[ -n "$line" ] || fail "there is no setting \"$circuit\" in $table"
top=$(echo "$line" | cut -d ' ' -f 3)
setting=
for parameter in $(echo "$line" | cut -s -d ' ' -f 5-); do
    setting="$setting -set ${parameter%=*} ${parameter#*=}"
done

mkdir -p "$dir"
# -nordff: register 2 stays in front of the ROMs, as in the Verilog; else Yosys would put registers
# of its own behind them.
yosys -q -p "
    read_verilog -Irtl rtl/*.v
    chparam $setting $top
    hierarchy -check -top $top
    synth -flatten -nordff
    rename -top $top
    write_rtlil $dir/healthy.il
    mutate -list $count -seed $seed -ctrl mutsel 16 1 -o $dir/mutants.list"
made=$(sed 's/-ctrl mutsel 16 [0-9]* //' "$dir/mutants.list" | sort -u | wc -l)
[ "$made" -eq "$count" ] ||
    fail "$circuit has no $count different faults: mutate found $made; ask for fewer"

# Vectors are split into bits: Verilator orders whole vectors, and would see loops where there are
# none. mutsel becomes a register: all that depends on a pin Verilator evaluates whenever some pin
# changes, and on mutsel depends everything.
yosys -q -p "
    read_rtlil $dir/healthy.il
    script $dir/mutants.list
    splitnets
    write_verilog -noattr $dir/netlist.v"
sed 's/^\(module .*\), mutsel);$/\1, fault, choose);/
    s/^  input \[15:0\] mutsel;$/  input [15:0] fault;\n  input choose;/
    s/^  wire \[15:0\] mutsel;$/  reg [15:0] mutsel;\
  always @(posedge choose) mutsel <= fault;/' \
    "$dir/netlist.v" >"$dir/mutants.v.new"
added='^  reg \[15:0\] mutsel;$|, fault, choose\);$|^  input choose;$'
[ "$(grep -cE "$added" "$dir/mutants.v.new")" = 3 ] ||
    fail "$circuit: Yosys wrote no input mutsel as expected to $dir/netlist.v"
rm "$dir/netlist.v"
mv "$dir/mutants.v.new" "$dir/mutants.v"
