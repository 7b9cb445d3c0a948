# Checks every #include line of the files named after layers.txt against its rules.
# Prints one line for each that breaks them: file:line: what, and why. Exit status 1 if any.

function fault(why) {
    printf "%s:%d: includes %s: %s\n", FILENAME, FNR, header, why
    faults++
}

# Whether path lies in one of the folders of a list of words.
function is_in(path, list,    words, n, i) {
    n = split(list, words, " ")
    for (i = 1; i <= n; i++)
        if (index(path, words[i] "/") == 1) return 1
    return 0
}

# The longest key of the table that text begins with; "" where none does.
function longest(text, table,    key, best) {
    best = ""
    for (key in table)
        if (index(text, key) == 1 && length(key) > length(best)) best = key
    return best
}

function exists(path,    line, status) {
    if (!(path in known)) {
        status = (getline line < path)
        known[path] = status >= 0
        if (status >= 0) close(path)
    }
    return known[path]
}

function read_rule(    words, n, i) {
    sub(/#.*/, "")
    if (NF == 0) return
    gsub(/[ \t]+/, " ")
    if (!match($0, /:/)) {
        printf "%s:%d: a rule needs a colon\n", FILENAME, FNR
        faults++
        return
    }
    n = split(substr($0, 1, RSTART - 1), words, " ")
    for (i = 2; i <= n; i++) {
        if (words[1] == "folder") folder[words[i] "/"] = substr($0, RSTART + 1)
        else library[words[i]] = substr($0, RSTART + 1)
    }
}

function check_own(    home) {
    home = longest(FILENAME, folder)
    if (home == "") fault("no rule names the folder of this file")
    else if (!exists(header)) fault("no such file; include by path from the root")
    else if (index(header, home) != 1 && !is_in(header, folder[home]))
        fault(substr(home, 1, length(home) - 1) " may include only:" (folder[home] ~ /[^ ]/ ? folder[home] : " itself"))
}

function check_library(    rule) {
    if (header ~ /^[a-z_0-9]+$/) return  # <vector>, <cmath>: the C++ library
    rule = longest(header, library)
    if (rule == "") fault("no rule names this library")
    else if (!is_in(FILENAME, library[rule])) fault("allowed in:" library[rule])
}

# A source file that includes its own header first proves that the header needs nothing before it.
function check_first(    own) {
    own = FILENAME
    if (sub(/\.cpp$/, ".h", own) && header != own && exists(own)) fault("its own header comes first: " own)
}

FILENAME ~ /layers\.txt$/ { read_rule(); next }

FNR == 1 { is_first = 1 }

/^[ \t]*#[ \t]*include/ {
    header = $0
    if (match(header, /"[^"]*"/)) kind = "own"
    else if (match(header, /<[^>]*>/)) kind = "library"
    else next
    header = substr(header, RSTART + 1, RLENGTH - 2)
    if (is_first) check_first()
    is_first = 0
    if (kind == "library" && longest(header, folder) == "") check_library()
    else check_own()
}

END { exit faults > 0 }
