# Reads any of the benchmark's CSV files: afterwards value(name, column) is a field of the row that is
# named by the first fields. Functions for writing tables in words and numbers.

FNR == 1 { machine = substr($0, 3); next }
FNR == 2 { for (i = 1; i <= NF; i++) column[$i] = i; next }

# field(NAME): of the line being read.
function field(name) { return $column[name] }

# 950, 4.1 k, 12 k, 3.4 M: nanoseconds for reading.
function short(ns) {
    if (ns == "") return "-"
    if (ns < 1000) return sprintf("%d", ns)
    if (ns < 9950) return sprintf("%.1f k", ns / 1000)
    if (ns < 999500) return sprintf("%d k", ns / 1000 + 0.5)
    return sprintf("%.1f M", ns / 1e6)
}

function remember(key,    at) {
    if (!(key in seen)) order[++count] = key
    seen[key] = 1
}

function rule(cells,    i, line) {
    line = "|---|"
    for (i = 0; i < cells; i++) line = line "---|"
    return line
}

# The head of a table with a column for each of `sizes`, which are then listed[1 ... columns].
function head_of_sizes(    n, line) {
    line = "| " curve " curve |"
    for (n = 512; n <= 1048576; n *= 2)
        if (n in sizes) {
            line = line " " n " edges |"
            listed[++columns] = n
        }
    return line
}

# The row of such a table: cell[key, size], a dash where there is none.
function row_of_sizes(key,    k, line) {
    line = "| " key " |"
    for (k = 1; k <= columns; k++) line = line " " (((key, listed[k]) in cell) ? cell[key, listed[k]] : "-") " |"
    return line
}
