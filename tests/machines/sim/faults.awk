# The table of faults: faults.awk LINES, as tests/machines/sim/fault_lines.h writes them.

BEGIN {
    FS = ";"
    print "| way | fault | runs | zero torque after, ms | worst state, in so many runs | force back | after, ms | left: files, bytes |"
    print "|---|---|---|---|---|---|---|---|"
}

{
    row = $1 " | " $2
    if (!(row in runs)) order[++rows] = row
    ++runs[row]
    if ($4 != "") zero[row] = zero[row] " " $4
    if (!((row, $5) in seen)) states[row] = states[row] ";" $5
    ++seen[row, $5]
    if ($6 != "") {
        back[row] = back[row] " " $6
        ++by[row, $7]
    }
    files[row] += $8
    bytes[row] += $9
}

# "median / worst" of numbers in a text.
function spread(text, count, values, i, j, value) {
    count = split(text, values, " ")
    if (count == 0) return "-"
    for (i = 2; i <= count; ++i) {
        value = values[i] + 0
        for (j = i - 1; j > 0 && values[j] + 0 > value; --j) values[j + 1] = values[j]
        values[j + 1] = value
    }
    return sprintf("%.2f / %.2f", values[int(count / 2) + 1], values[count])
}

# Each state with how often it came, where there are several.
function told(row, count, names, i, text) {
    count = split(substr(states[row], 2), names, ";")
    for (i = 1; i <= count; ++i) {
        text = text (i > 1 ? "; " : "") names[i]
        if (count > 1) text = text ": " seen[row, names[i]]
    }
    return text
}

function returned(row, itself, anew) {
    itself = by[row, 1] + 0
    anew = by[row, 0] + 0
    if (itself + anew == 0) return "-"
    if (anew == 0) return "by itself"
    return itself == 0 ? "anew" : "by itself: " itself "; anew: " anew
}

END {
    for (r = 1; r <= rows; ++r) {
        row = order[r]
        printf "| %s | %d | %s | %s | %s | %s | %d, %d |\n", row, runs[row], spread(zero[row]),
            told(row), returned(row), spread(back[row]), files[row], bytes[row]
    }
}
