# What a subcommand's --help says of its options, a line each, with tabs between: name, value (as
# a|b|c, N, FILE …; empty for a flag), what it does.

function flush() {
    if (name != "")
        print name "\t" value "\t" help
    name = ""
}

/^Options:/ { listed = 1; next }
listed && /^ *$/ { listed = 0 }
!listed { next }

/^  --/ {
    flush()
    line = substr($0, 5)
    # The help follows after two blanks, or on the next line.
    at = match(line, /  +/)
    help = at ? substr(line, at + RLENGTH) : ""
    if (at)
        line = substr(line, 1, at - 1)
    at = index(line, " ")
    name = at ? substr(line, 1, at - 1) : line
    value = at ? substr(line, at + 1) : ""
    next
}

# A list of words goes on in the next line behind a bar.
value ~ /\|$/ && help == "" {
    sub(/^ +/, "")
    value = value $0
    next
}

{
    sub(/^ +/, "")
    help = help (help == "" ? "" : " ") $0
}

END { flush() }
