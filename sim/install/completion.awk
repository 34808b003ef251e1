# The completion of the command for a shell (-v shell=bash, zsh or fish), of two files: subcommands
# ("name, what it does") and options ("subcommand, name, value, what it does"), with tabs between.

BEGIN { FS = "\t" }

# The words that a value may be: the lower-case ones of a|b|FILE, or what the help names.
function words_of(value, help,    parts, count, i, words) {
    words = ""
    if ((value == "MODEL" || value == "CIRCUIT") && match(help, /one of [a-z0-9 -]+/)) {
        return substr(help, RSTART + 7, RLENGTH - 7)
    }
    if (index(value, "|") == 0)
        return ""
    count = split(value, parts, "|")
    for (i = 1; i <= count; i++)
        if (parts[i] !~ /[A-Z]/)
            words = words (words == "" ? "" : " ") parts[i]
    return words
}

function quoted(text) {
    gsub(/'/, "'\\''", text)
    return "'" text "'"
}

# zsh gives [ ] : a meaning in the specification of an option.
function zsh_text(text) {
    gsub(/\\|\[|\]|:/, "\\\\&", text)
    return text
}

# The first half of the help, up to where details begin.
function short(help) {
    sub(/ \(default [^)]*\)$/, "", help)
    sub(/[;:] .*/, "", help)
    return help
}

FNR == NR {
    subcommand[++subcommands] = $1
    purpose[$1] = $2
    next
}

{
    i = ++options
    of[i] = $1
    name[i] = $2
    value[i] = $3
    help[i] = short($4)
    words[i] = words_of($3, $4)
    file[i] = $3 ~ /FILE|DIR|PACKET/
}

END {
    if (shell == "bash")
        bash()
    else if (shell == "zsh")
        zsh()
    else
        fish()
}

function bash(    i, s) {
    print "# Completion of glint for bash, made of its --help."
    print "_glint() {"
    print "    local current=${COMP_WORDS[COMP_CWORD]} words= files="
    print "    if [ \"$COMP_CWORD\" -eq 1 ]; then"
    printf "        words='"
    for (s = 1; s <= subcommands; s++)
        printf "%s ", subcommand[s]
    print "help --help --version'"
    print "    else"
    print "        case \"${COMP_WORDS[1]} ${COMP_WORDS[COMP_CWORD - 1]}\" in"
    for (i = 1; i <= options; i++)
        if (value[i] != "")
            printf "        '%s --%s') words='%s' files=%s ;;\n", of[i], name[i], words[i], file[i] ? "yes" : ""
    print "        *)"
    print "            files=yes"
    print "            case ${COMP_WORDS[1]} in"
    printf "            help) files= words='"
    for (s = 1; s <= subcommands; s++)
        printf "%s%s", (s == 1 ? "" : " "), subcommand[s]
    print "' ;;"
    for (s = 1; s <= subcommands; s++) {
        printf "            %s) words='", subcommand[s]
        for (i = 1; i <= options; i++)
            if (of[i] == subcommand[s])
                printf "--%s ", name[i]
        print "' ;;"
    }
    print "            esac ;;"
    print "        esac"
    print "    fi"
    print "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\";"
    print "                            [ -z \"$files\" ] || compgen -f -- \"$current\")"
    print "}"
    print "complete -o filenames -F _glint glint"
}

function zsh(    i, s) {
    print "#compdef glint"
    print "# Completion of glint for zsh, made of its --help."
    print "local -a subcommands=("
    for (s = 1; s <= subcommands; s++)
        printf "    %s\n", quoted(subcommand[s] ":" zsh_text(purpose[subcommand[s]]))
    print ")"
    print "if (( CURRENT == 2 )); then"
    print "    _describe subcommand subcommands"
    print "    return"
    print "fi"
    print "shift words"
    print "(( CURRENT-- ))"
    print "case $words[1] in"
    for (s = 1; s <= subcommands; s++) {
        printf "%s)\n    _arguments", subcommand[s]
        for (i = 1; i <= options; i++)
            if (of[i] == subcommand[s])
                printf " \\\n        %s", quoted("--" name[i] "[" zsh_text(help[i]) "]" zsh_value(i))
        print " \\\n        '*:file:_files' ;;"
    }
    print "help) _describe subcommand subcommands ;;"
    print "esac"
}

function zsh_value(i) {
    if (value[i] == "")
        return ""
    if (words[i] != "")
        return ":" zsh_text(name[i]) ":" (file[i] ? "{compadd " words[i] "; _files}" : "(" words[i] ")")
    return ":" zsh_text(name[i]) ":" (file[i] ? "_files" : "( )")
}

function fish(    i, s) {
    print "# Completion of glint for fish, made of its --help."
    print "complete -c glint -n __fish_use_subcommand -f"
    for (s = 1; s <= subcommands; s++)
        printf "complete -c glint -n __fish_use_subcommand -a %s -d %s\n", subcommand[s], \
            quoted(purpose[subcommand[s]])
    for (i = 1; i <= options; i++)
        printf "complete -c glint -n '__fish_seen_subcommand_from %s' -l %s%s%s -d %s\n", of[i], name[i], \
            value[i] == "" ? "" : file[i] ? " -r" : " -x", words[i] == "" ? "" : " -a " quoted(words[i]), \
            quoted(help[i])
}
