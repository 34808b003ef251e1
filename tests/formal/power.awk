# The proofs of the power device's settings, from the lines of build/settings: every lane of every
# setting that leaves W as wide as it is, and the ROMs of each accuracy.
$1 == "power" && split($2, part, "_") == 4 { # power, accuracy, pipeline, lanes
    for (lane = 0; lane < part[4]; lane++)
        print "power-" part[2] "-" part[3] "-" part[4] "-" lane
    roms = "power_roms-" part[2]
    if (!(roms in printed))
        print roms
    printed[roms] = 1
}
