# The proofs of the specular device's settings, from the lines of build/settings: every lane of every
# setting; that the gates are equal, for each pipeline and number of lanes; and the ROMs.
$1 == "specular" {
    split($2, part, "_") # specular, gate, pipeline, lanes
    for (lane = 0; lane < part[4]; lane++) {
        print "device-" part[2] "-" part[3] "-" part[4] "-" lane
        gates = "gates-" part[3] "-" part[4] "-" lane
        if (!(gates in printed))
            print gates
        printed[gates] = 1
    }
    any = 1
}
END {
    if (any)
        print "roms"
}
