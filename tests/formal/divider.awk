# The proofs of the dividers' settings, from the lines of build/settings: both forms, and the table of
# each number of shifts.
$1 == "divider" {
    split($2, part, "_") # divider, form, shifts
    print part[2] "-" part[3]
    if (!(part[3] in printed))
        print "table-" part[3]
    printed[part[3]] = 1
}
