# What the circuits' counters say, as a table by module, with the reason for each line and toggle that
# cannot come.
#
#   awk -f tests/coverage/report.awk IMPOSSIBLE COUNTS...
#
# IMPOSSIBLE  a reason a line: CIRCUITS MODULE ITEM REASON, the first three without spaces.
#             CIRCUITS  names separated by commas, * in them for anything
#             MODULE    of rtl/, or MODULE@INSTANCE with the end of its path, * for anything
#             ITEM      of toggles signal, signal[bit] or signal[high:low], the bounds sums of
#                       numbers, n and j; of lines line:NUMBER. * for anything. n is the last number
#                       of the circuit's name, j that of the instance's path; of an array signal[j],
#                       its index
#             A line that begins with # is a comment.
# COUNTS      what Verilator's counters wrote, CIRCUIT-NUMBER.dat; of a circuit's files the largest
#             count of an item is taken, whether the circuit's top is the uppermost module or stands
#             as "dut" in the glint_probe that reads its signals, which is no part of it
#
# A line is covered when it ran; a toggle when the bit changed at least twice, which is both ways as
# all begin with 0. Prints the table, the reasons with the number of items of each, and each item that
# is not covered and has no reason. The last lines are "lines: N items, F failed" and the same of
# toggles. Exit status 1 when an item failed, when a reason is given for what is covered or for
# nothing, or when there is nothing.

function fail(text) {
    print text
    failed = 1
}

# A pattern with * as a regular expression of the whole.
function pattern(text) {
    gsub(/[][.+?(){}|^$\\]/, "\\\\&", text)
    gsub(/\*/, ".*", text)
    return "^" text "$"
}

function matches_any(text, patterns,   part, count, i) {
    count = split(patterns, part, ",")
    for (i = 1; i <= count; i++)
        if (text ~ pattern(part[i]))
            return 1
    return 0
}

FNR == 1 { file_number++ }

file_number == 1 && !/^#/ && NF {
    if (NF < 4) {
        fail(FILENAME ":" FNR ": circuits, module, item and reason are needed")
        next
    }
    reasons++
    circuits[reasons] = $1
    instance[reasons] = index($2, "@") ? substr($2, index($2, "@") + 1) : ""
    module[reasons] = index($2, "@") ? substr($2, 1, index($2, "@") - 1) : $2
    item[reasons] = $3
    high[reasons] = low[reasons] = ""
    if (match($3, /\[[0-9nj:-]*\]$/) && substr($3, RSTART) != "[j]") {
        item[reasons] = substr($3, 1, RSTART - 1)
        range = substr($3, RSTART + 1, RLENGTH - 2)
        split(range, bound, ":")
        high[reasons] = bound[1]
        low[reasons] = index(range, ":") ? bound[2] : bound[1]
    }
    text = $0
    sub(/^[^ \t]+[ \t]+[^ \t]+[ \t]+[^ \t]+[ \t]+/, "", text)
    reason[reasons] = text
    place[reasons] = FILENAME ":" FNR
}

# The fields of a counter's line are NAME\002VALUE after a \001 each.
function field_of(line, name,   rest) {
    if (!index(line, "\001" name "\002"))
        return ""
    rest = substr(line, index(line, "\001" name "\002") + length(name) + 2)
    sub(/[\001'].*/, "", rest)
    return rest
}

file_number > 1 && /^C / {
    circuit = FILENAME
    sub(/.*\//, "", circuit)
    sub(/-[0-9]+\.dat$/, "", circuit)
    page = field_of($0, "page")
    kind = page ~ /^v_toggle/ ? "toggle" : "line"
    name = page
    sub(/.*\//, "", name)
    sub(/__.*/, "", name)
    if (name == "glint_probe")
        next
    path = field_of($0, "h")
    sub(/^TOP\.(glint_probe\.dut|[^.]*)/, "TOP.top", path)
    file = field_of($0, "f")
    sub(/.*\//, "", file)
    count = $0
    sub(/.*' /, "", count)
    key = circuit SUBSEP name SUBSEP path SUBSEP kind SUBSEP file SUBSEP \
          field_of($0, "l") SUBSEP field_of($0, "n") SUBSEP field_of($0, "o")
    if (!(key in largest) || count + 0 > largest[key])
        largest[key] = count + 0
}

# The value of a bound: a sum of numbers, n and j.
function value_of(sum, n, j,   sign, value, part) {
    value = 0
    sign = 1
    while (match(sum, /[0-9]+|[nj-]/)) {
        part = substr(sum, RSTART, RLENGTH)
        sum = substr(sum, RSTART + RLENGTH)
        if (part == "-") {
            sign = -1
            continue
        }
        value += sign * (part == "n" ? n : part == "j" ? j : part)
        sign = 1
    }
    return value
}

# The reason of an item, 0 when it has none. Looks also whether a reason is given for a covered one.
function reason_of(circuit, name, path, kind, line, signal, covered,   base, bit, r, found, n, j) {
    base = signal
    bit = -1
    if (match(signal, /\[[0-9]+\]$/)) {
        base = substr(signal, 1, RSTART - 1)
        bit = substr(signal, RSTART + 1, RLENGTH - 2) + 0
    }
    n = circuit
    sub(/.*[-_]/, "", n)
    j = path
    gsub(/[^0-9]+/, " ", j)
    sub(/ $/, "", j)
    sub(/.* /, "", j)
    if (match(base, /\[[0-9]+\]$/)) { # an element of an array
        j = substr(base, RSTART + 1, RLENGTH - 2)
        base = substr(base, 1, RSTART - 1) "[j]"
    }
    if (kind == "line")
        base = "line:" line
    found = 0
    for (r = 1; r <= reasons; r++) {
        if (module[r] != name || base !~ pattern(item[r]))
            continue
        if (high[r] != "" && (bit > value_of(high[r], n, j) || bit < value_of(low[r], n, j)))
            continue
        if (!matches_any(circuit, circuits[r]))
            continue
        if (instance[r] != "" && path !~ pattern("*" instance[r]))
            continue
        if (covered) {
            if (!(r in contradicted))
                fail(place[r] ": " circuit ": " path "." signal " is covered, so the reason does not hold")
            contradicted[r] = 1
        } else if (!found) {
            found = r
        }
    }
    return found
}

END {
    for (key in largest) {
        split(key, part, SUBSEP)
        name = part[2]
        kind = part[4]
        modules[name] = 1
        total[name, kind]++
        items[kind]++
        covered = largest[key] >= (kind == "toggle" ? 2 : 1)
        r = reason_of(part[1], name, part[3], kind, part[6], part[8], covered)
        if (covered) {
            done[name, kind]++
        } else if (r) {
            explained[name, kind]++
            uses[r]++
        } else {
            bad[kind]++
            missing[++missing_count] = part[5] ":" part[6] ": " part[8] ", " kind " of " part[3] \
                                       ", circuit " part[1]
        }
    }
    printf "%-20s %27s  %27s\n", "", "lines and branches", "toggles"
    printf "%-20s %8s %9s %8s  %8s %9s %8s\n", "module", "covered", "explained", "total", "covered",
           "explained", "total"
    fflush() # before what sort prints
    order = "sort"
    for (name in modules)
        printf "%-20s %8d %9d %8d  %8d %9d %8d\n", name, done[name, "line"], explained[name, "line"],
               total[name, "line"], done[name, "toggle"], explained[name, "toggle"],
               total[name, "toggle"] | order
    close(order)
    print "\nnot covered, and why:"
    for (r = 1; r <= reasons; r++) {
        if (!(r in uses) && !(r in contradicted))
            fail(place[r] ": there is nothing uncovered that this is the reason of")
        printf "%6d  %s %s %s: %s\n", uses[r], circuits[r], \
               module[r] (instance[r] != "" ? "@" instance[r] : ""), \
               item[r] (high[r] == "" ? "" : "[" (high[r] == low[r] ? high[r] : high[r] ":" low[r]) "]"), \
               reason[r]
    }
    if (missing_count > 0)
        printf "\nnot covered, without a reason:\n"
    fflush()
    for (i = 1; i <= missing_count; i++)
        print "  " missing[i] | order
    close(order)
    printf "\nlines: %d items, %d failed\ntoggles: %d items, %d failed\n", items["line"], bad["line"],
           items["toggle"], bad["toggle"]
    exit failed || missing_count > 0 || !items["line"] || !items["toggle"]
}
