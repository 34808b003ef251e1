# Functions that no test enters, each with its reason.
#
#   awk -f tests/coverage/functions.awk REASONS GCOVR.json
#
# REASONS     lines FILE FUNCTION REASON; # begins a comment
# GCOVR.json  what gcovr --json wrote
#
# Prints the functions that are not entered, with the reason, and last "functions: N items, F
# failed". Exit status 1 if one has no reason, if a reason is for a function that is entered or does
# not exist, or if there are no functions.

FNR == 1 { file_number++ }

file_number == 1 && !/^#/ && NF {
    text = $0
    sub(/^[^ ]+ +[^ ]+ +/, "", text)
    reason[$1 " " $2] = text
    next
}

# The value of a field of a JSON object without objects inside.
function value_of(object, name,   text) {
    if (!match(object, "\"" name "\": (\"[^\"]*\"|[0-9]+)"))
        return ""
    text = substr(object, RSTART + length(name) + 4, RLENGTH - length(name) - 4)
    gsub(/"/, "", text)
    return text
}

function take_functions(source, list,   object, count, i, name) {
    count = split(list, object, "}")
    for (i = 1; i <= count; i++) {
        name = value_of(object[i], "name")
        if (name == "")
            continue
        total++
        if (value_of(object[i], "execution_count") + 0 > 0)
            entered[source " " name] = 1
        else
            open[source " " name] = 1
    }
}

# A file's name comes before its functions, and everything may be on one line.
file_number > 1 {
    rest = $0
    while (match(rest, /"file": "[^"]*"|"functions": \[[^]]*\]/)) {
        piece = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (piece ~ /^"file"/)
            source = value_of(piece, "file")
        else
            take_functions(source, piece)
    }
}

END {
    fflush()
    for (name in open) {
        if (name in reason) {
            print "  " name ": " reason[name] | "sort"
        } else {
            print "  " name ": no test enters it" | "sort"
            failed++
        }
    }
    close("sort")
    for (name in reason)
        if (!(name in open)) {
            print name ": " (name in entered ? "entered, so that the reason does not hold" : "no such function")
            wrong = 1
        }
    printf "functions: %d items, %d failed\n", total, failed
    exit wrong || failed > 0 || total == 0
}
