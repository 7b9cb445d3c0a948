# From the death of the servo to force, against the edges of the picture.

FNR > 2 {
    remember($1)
    row[$1] = sprintf("| %d | %d | %d | %d | %d | %.1f |", $1, field("runs"), field("median_ms"), field("p90_ms"), field("most_ms"), field("load"))
    if (field("median_ms") > most_ms) most_ms = field("median_ms")
}

END {
    print "| edges | runs | median, ms | 90 of 100, ms | most, ms | load |"
    print rule(5)
    for (i = 1; i <= count; i++) print row[order[i]]
    printf "\nMeasured %s.\n\nIn words: half of the servos that are killed have their force back within %.2f s, whatever the picture (bar 0.5 s: %s).\n", \
        machine, most_ms / 1000, most_ms <= 500 ? "met" : "missed"
}
