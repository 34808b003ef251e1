# How a unit is synthesised, placed and routed for each family: sourced by compare.sh and job.sh.
# A recipe's text is part of what its result is filed under, so an edit here makes anew what it
# changes, and only that.
#
# Needs: $home (BUILD/compare), $rtl (the Verilog's directory), $versions (a directory, a file with
# a version for each tool), $here (this directory).

liberty=/usr/share/qflow/tech/osu018/osu018_stdcells.lib

# Flows whose cells are counted, by the newest Yosys and by Debian's; those that are placed; one of
# which either takes long; and those that are placed last, since one of them has no multiplier's
# delay and the other crashes.
sizes='ecp5 cells xilinx gowin cyclonev ice40dsp'
sizes_debian='xilinx ecp5 ice40 ice40dsp cyclonev'
clocks='ecp5 up5k'
slow='ice40'
late='nexus gowin'
seeds='1 2 3'

# Yosys's commands for one flow, after the Verilog has been read.
synthesis_of() { # FLOW
    case $1 in
    xilinx) echo 'synth_xilinx -family xc7 -flatten -noiopad -noclkbuf -top compare_unit' ;;
    ecp5) echo 'synth_ecp5 -top compare_unit' ;;
    ice40) echo 'synth_ice40 -top compare_unit' ;;
    ice40dsp | up5k) echo 'synth_ice40 -dsp -top compare_unit' ;;
    gowin) echo 'synth_gowin -family gw2a -noiopads -top compare_unit' ;;
    cyclonev) echo 'synth_intel_alm -family cyclonev -noiopad -noclkbuf -top compare_unit' ;;
    # The gates are sized and buffered for a period that they cannot reach.
    cells) echo "synth -flatten -top compare_unit; dfflibmap -liberty $liberty;\
 abc -liberty $liberty -D 1000 -constr $here/cells.constr; splitnets -ports; opt_clean -purge;\
 setundef -zero; write_verilog -noattr -noexpr -nohex netlist.v" ;;
    esac
}

# For placing: with pads, the clock's source, and what a tool needs done to its netlist.
placeable_of() { # FLOW
    case $1 in
    gowin) echo 'synth_gowin -family gw2a -top compare_unit' ;;
    # The clock comes from the oscillator. A carry chain's first input may be open, which is 0, but
    # not tied to 0, as Yosys leaves it (its issue 4081).
    nexus) echo "read_verilog $here/nexus_clock.v; synth_nexus -top compare_clocked;\
 techmap -map $here/nexus_low.v; opt_clean; techmap -max_iter 1 -map $here/nexus_carry.v;\
 opt_clean; hilomap -singleton -hicell VHI Z -locell VLO Z" ;;
    *) synthesis_of "$1" ;;
    esac
}

# nextpnr's arguments. The period asked for is out of reach, so that it never has reason to stop.
placement_of() { # FLOW
    case $1 in
    ice40) echo '--hx8k --package ct256 --freq 300' ;;
    up5k) echo '--up5k --package sg48 --freq 300' ;;
    ecp5) echo '--25k --package CABGA381 --speed 6 --freq 300' ;;
    nexus) echo "--device LIFCL-40-9BG400CES --pdc $here/nexus.pdc" ;;
    gowin) echo "--device GW2A-LV18PG256C8/I7 --vopt family=GW2A-18 --vopt cst=$here/gowin.cst\
 --freq 300" ;;
    esac
}

placer_of() { # FLOW
    case $1 in
    ice40 | up5k) echo nextpnr-ice40 ;;
    gowin) echo nextpnr-himbaechel-gowin ;;
    *) echo "nextpnr-$1" ;;
    esac
}

# Everything that a result depends on, but for the seed.
recipe_of() { # KIND FLOW NAME
    case $1 in
    errors) cat "$home/model" "$home/modules/$3.bare.v" ;;
    size | debian) synthesis_of "$2" && cat "$home/modules/$3.bare.v" ;;
    clock) placeable_of "$2" && placement_of "$2" && cat "$home/modules/$3.timed.v" ;;
    esac
    case $2 in
    cells) cat "$here/cells.constr" "$here/cells.tcl" ;;
    nexus) cat "$here"/nexus* ;;
    gowin) cat "$here/gowin.cst" ;;
    esac
    tools_of "$1" "$2"
}

# With their versions, for the tables.
tools_of() { # KIND FLOW
    case $1 in
    errors) return ;;
    size) cat "$versions/yosys" ;;
    debian) cat "$versions/yosys-debian" ;;
    clock) cat "$versions/yosys" "$versions/$(placer_of "$2")" ;;
    esac
    [ "$2" != cells ] || cat "$versions/sta"
}

# Where the result is filed. VERILOG: the hash of what the unit is made of.
result_of() { # NAME VERILOG KIND FLOW SEED
    key=$({ echo "$2" && recipe_of "$3" "$4" "$1"; } | sha256sum | cut -c 1-16)
    echo "$home/results/$1.$3.$4.$5.$key.json"
}
