#!/bin/sh
# Tries to prove that one fault of a netlist cannot be seen at the pins, ever.
#
#   tests/mutation/prove.sh DIR MUTANT SECONDS
#
# DIR is where healthy.il and mutants.list of mutants.sh are; MUTANT is a line of the latter. Prints
#   equivalent HOW       proven, by "induction", "reachability" or "points": see below
#   different  -         the solver found inputs that show the fault; with a point, if there is one:
#   different  n=…,cos=…,rgb=…,…,…       (bench --mutant N --point … shows it)
#   open       -         neither, after SECONDS of processor time for each attempt
# with a tab between. Exit status 0 for each of them, 2 when a tool failed.
#
# What is proven: the netlist and the one with the fault, side by side, each with registers of any
# content, one clock of reset, then any inputs at all, for ever: after every rising edge all outputs
# are equal.
#   points        of the specular device, for faults in its arithmetic and ROMs; docs/mutation.md
#                 has the argument: what a point becomes is the same, by SAT over all n, cosines,
#                 colours
#   induction     registers and gates that are equal in every reachable step are merged, by SAT,
#                 until nothing is left that could differ
#   reachability  property-directed reachability (ABC's pdr), which checks the invariant that it
#                 found again, on what the merging left; on the same pair written with differences
#                 (differences.awk); and else the several engines of dprove
set -eu

fail() {
    echo "tests/mutation/prove.sh: $*" >&2
    exit 2
}

[ $# -eq 3 ] || fail "three arguments, not $#: DIR MUTANT SECONDS"
dir=$1 mutant=$2 seconds=$3
here=$(dirname "$0")
top=$(sed -n 's/^module \\//p' "$dir/healthy.il")
fault=$(sed -n "${mutant}p" "$dir/mutants.list")
[ -n "$fault" ] || fail "$dir/mutants.list has no line $mutant"
fault=$(printf '%s\n' "$fault" |
    sed 's/ -ctrl mutsel [0-9]* [0-9]*//; s/ -module [^ ]*/ -module faulty/')
cell=$(printf '%s\n' "$fault" | sed 's/.* -cell \([^ ]*\) .*/\1/')
port=$(printf '%s\n' "$fault" | sed 's/.* -port \([^ ]*\) .*/\1/')

work=$(mktemp -d) || fail "cannot make a temporary directory"
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

run_yosys() { # SCRIPT: false when a command of it failed, an assertion for instance
    yosys -q -p "$1" >"$work/yosys.log" 2>&1
}

# Both modules, the healthy one and the faulty, in Yosys.
pair="
    read_rtlil $dir/healthy.il
    copy $top faulty
    $fault"

# Makes $work/NAME.aig of a top module NAME that has the pair of them, the module "both", in it.
build() { # NAME SCRIPT
    run_yosys "$pair
        $2
        hierarchy -check -top $1
        proc
        flatten
        techmap
        dffunmap
        simplemap
        opt_clean
        aigmap
        write_aiger -zinit -map $work/$1.map $work/$1.aig" ||
        { cat "$work/yosys.log" >&2 && fail "Yosys could not build $1 for mutant $mutant"; }
}

# Asks ABC, with a limit on its processor time: on a busy machine it is given no less of that.
run_abc() { # COMMANDS [SECONDS]
    status=0
    { (
        ulimit -c 0
        ulimit -t "${2:-$seconds}"
        exec yosys-abc -c "$1" >"$work/abc.log" 2>&1
    ) || status=$?; } 2>/dev/null # where the shell says that time is up
    case $(kill -l $status 2>/dev/null) in
    XCPU | KILL) return ;;
    esac
    [ "$status" -eq 0 ] || fail "yosys-abc failed on mutant $mutant"
}

# 1 proven, 0 refuted, -1 neither, nothing when the time ran out.
abc_status() {
    sed -n 's/^Status = \(-*[0-9]*\) .*/\1/p' "$work/abc.log"
}

answer() { # WORD DETAIL
    printf '%s\t%s\n' "$1" "$2"
    exit 0
}

# ---- One point through the specular device ------------------------------------------------------

# A register that no reset clears.
resets_nothing() {
    [ "$port" = R ] && case $fault in *" -mode const0 "*) true ;; *) false ;; esac
}

may_be_judged_by_points() {
    [ "$top" = specular_device ] || return 1
    case $port in
    C | E) return 1 ;;
    R) resets_nothing || return 1 ;;
    esac
    run_yosys "
        read_rtlil $dir/healthy.il
        select -module $top
        select -set fault c:$cell
        script $here/points.ys
        $(! resets_nothing || echo select -assert-count 1 @fault @later %i)"
}

# A string of 0 and 1, the lowest bit first, as a number.
number() { # FIRST WIDTH
    cut -c "$1-$(($1 + $2 - 1))" "$work/point" |
        awk '{ for (i = length($0); i > 0; i--) n = 2 * n + substr($0, i, 1); print n + 0 }'
}

# What the reset leaves in the pipeline, and then what any point becomes.
try_points() {
    build after_reset "
        miter -equiv -flatten $top faulty both
        read_verilog $here/points.v"
    run_abc "read $work/after_reset.aig; strash; dprove; print_status"
    [ "$(abc_status)" = 1 ] || return 0
    ! resets_nothing || answer equivalent points
    build one_point "
        read_verilog -icells $here/wires.v
        techmap -map $here/wires.v $top faulty
        miter -equiv -flatten $top faulty both
        read_verilog $here/points.v"
    run_abc "read $work/one_point.aig; strash; iprove; print_status; write_cex $work/point"
    case $(abc_status) in
    1) answer equivalent points ;;
    0) answer different \
        "n=$(number 1 10),cos=$(number 35 19),rgb=$(number 11 8),$(number 19 8),$(number 27 8)" ;;
    esac
}

# ---- The two netlists from the reset on ---------------------------------------------------------

# A fault of a clock pin is judged with the clock as a signal of two halves, low and high, where the
# inputs may change in each; of any other pin with a clock for each step.
halves=0 first_steps=1
[ "$port" != C ] || { halves=1 first_steps=3; }

# The module around the two: reset at the beginning, and nothing compared before its edge.
write_from_reset() {
    awk -v halves=$halves '
        /^  wire .*input / {
            width = 1
            for (i = 2; i < NF; i++)
                if ($i == "width")
                    width = $(i + 1)
            name = substr($NF, 2)
            if (name == "clk")
                next
            ports = ports sprintf("input [%d:0] %s, ", width - 1, name)
            pins = pins sprintf(", .in_%s(%s)", name, name == "reset" ? "reset | !started" : name)
        }
        END {
            print "module from_reset(input clk, " ports "output seen);"
            print "reg started = 0, high = 0; wire differs;"
            print "always @(posedge clk) high <= !high;"
            print "always @(posedge clk) if (" (halves ? "high" : "1") ") started <= 1;"
            print "both pair(.in_clk(" (halves ? "high" : "clk") ")" pins ", .trigger(differs));"
            print "assign seen = differs & started" (halves ? " & high" : "") ";"
            print "endmodule"
        }' "$dir/healthy.il" >"$work/from_reset.v"
}

# Registers of unknown content become inputs of the first step (-zinit). The first steps, in which
# the reset acts and nothing is compared, become part of the initial state.
try_from_reset() {
    write_from_reset
    build from_reset "
        miter -equiv -flatten $top faulty both
        $([ $halves = 0 ] || echo clk2fflogic both)
        read_verilog $work/from_reset.v"
    after_reset="read $work/from_reset.aig; strash; tempor -F $first_steps"
    # What pdr does not find in a tenth of the time it seldom finds in all of it.
    try_engine "$after_reset; scorr" pdr $((seconds / 10 + 1))
    run_abc "$after_reset; write_blif $work/from_reset.blif"
    awk -f "$here/differences.awk" "$work/from_reset.map" "$work/from_reset.blif" \
        >"$work/differences.blif"
    try_engine "read $work/differences.blif; strash; scorr; dc2" 'pdr -r -m' "$seconds"
    try_engine "$after_reset; scorr" dprove "$seconds"
}

# Merges, and asks an engine about the rest.
try_engine() { # PREPARATION ENGINE SECONDS
    run_abc "$1; print_stats; $2; print_status" "$3"
    case $(abc_status) in
    1)
        ! grep -q ' lat = *0  and = *0 ' "$work/abc.log" || answer equivalent induction
        answer equivalent reachability
        ;;
    0) answer different - ;;
    esac
}

! may_be_judged_by_points || try_points
try_from_reset
answer open -
