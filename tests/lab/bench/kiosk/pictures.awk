# From a picture that is chosen to force, against its megapixels.

FNR > 2 {
    remember($1)
    row[$1] = sprintf("| %s | %d | %d | %d | %d | %.1f |", $1, field("median_ms"), field("p90_ms"), field("most_ms"), field("processor_ms"), field("load"))
    processor_ms[$1] = field("processor_ms")
    median_ms[$1] = field("median_ms")
}

END {
    print "| megapixels | median, ms | 90 of 100, ms | most, ms | of it the workers' processor time, ms | load |"
    print rule(5)
    for (i = 1; i <= count; i++) print row[order[i]]
    printf "\nMeasured %s.\n\nIn words: half of the JPEGs of 12 megapixels are felt within %.2f s (bar 1 s: %s),\nfor which the workers need %.2f s of a processor.\n", machine, \
        median_ms[12] / 1000, median_ms[12] <= 1000 ? "met" : "missed", processor_ms[12] / 1000
}
