# Writes the pair of netlists of prove.sh anew, with the faulty one's registers as differences: what
# was a register of it is now the exclusive or of the healthy one's and of a register that holds in
# what the two differ. The behaviour is the same; but that a difference never gets anywhere is an
# invariant of a few of these registers, where else it is one of all pairs.
#
#   awk -f differences.awk MAP BLIF
#
# MAP is what Yosys's write_aiger says of its latches' names, BLIF what ABC makes of the same
# circuit after its tempor: the same latches in the same order, behind one of tempor's own. A pair
# that is matched wrongly still gives the same behaviour.
BEGIN {
    count = 0
}
FNR == NR {
    if ($1 == "latch" && $4 ~ /^pair\.g(old|ate)\./) {
        name = $4 " " $3
        sub(/^pair\.g[a-z]*\./, "", name)
        if ($4 ~ /^pair\.gold/)
            healthy[name] = $2 + 1
        else
            names[$2 + 1] = names[$2 + 1] "\n" name
    }
    next
}
$1 == ".latch" {
    next_of[count] = $2
    register[count] = $3
    initial[count++] = $NF
    next
}
$1 == ".end" {
    for (i = 0; i < count; i++)
        write_register(i, partner_of(i))
}
{
    print
}

# The healthy register of one of the names; -1 for none, or with another value at the beginning.
function partner_of(i,    n, k, name) {
    n = split(names[i], name, "\n")
    for (k = 2; k <= n; k++)
        if (name[k] in healthy && initial[i] == 0 && initial[healthy[name[k]]] == 0)
            return healthy[name[k]]
    return -1
}

function write_register(i, partner,    difference) {
    if (partner < 0) {
        print ".latch " next_of[i] " " register[i] " " initial[i]
        return
    }
    difference = register[i] "_differs"
    write_xor(next_of[i], next_of[partner], "next_" difference)
    print ".latch next_" difference " " difference " 0"
    write_xor(difference, register[partner], register[i])
}

function write_xor(a, b, result) {
    if (a == b) # which ABC refuses as operands
        print ".names " result
    else
        print ".names " a " " b " " result "\n10 1\n01 1"
}
