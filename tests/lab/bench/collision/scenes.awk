# The step against the number of outlines.

FNR > 2 {
    outlines = field("outlines")
    remember(outlines)
    cell[field("row"), outlines] = short(field("median_ns")) " / " short(field("p99_ns")) " / " short(field("max_ns"))
    m = field("median_ns")
    row = field("row")
    if (!(row in least) || m + 0 < least[row]) least[row] = m + 0
    if (m + 0 > most[row] + 0) most[row] = m + 0
    through += field("let_through")
    edges = field("edges")
}

END {
    print "| outlines (" edges " edges in all) | level auto | level 0 |"
    print rule(2)
    for (i = 1; i <= count; i++)
        print "| " order[i] " | " cell["Touchline level auto", order[i]] " | " cell["Touchline level 0", order[i]] " |"
    printf "\nIn words: from 1 to 10 000 outlines the slowest median is %.2f times the fastest with the level by speed and %.2f times at\n", \
        most["Touchline level auto"] / least["Touchline level auto"], most["Touchline level 0"] / least["Touchline level 0"]
    printf "level 0; the aim is 1.5. %s a line.\n", through == 0 ? "No step went through" : through " steps went through"
}
