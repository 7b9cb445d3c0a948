# One query a step: from the top, from the start grid, of a kept front.

FNR > 2 {
    way = field("row")
    remember(way)
    place = field("curve") " " field("edges") ", level " field("level") " (" sprintf("%.2g", field("spacing_mm")) " mm)"
    if (!(place in is_listed)) listed[++places] = place
    is_listed[place] = 1
    median[way, place] = field("median_ns")
    p99[way, place] = field("p99_ns")
    cell[way, place] = short(field("median_ns")) " / " short(field("p99_ns")) " / " short(field("max_ns")) "; " field("boxes_mean")
    hits[way, place] = field("hits")
}

# range(OF, A, B): the range of a ratio over all places, in words.
function range(of, a, b,    i, ratio, low, high) {
    for (i = 1; i <= places; i++) {
        ratio = of[a, listed[i]] / of[b, listed[i]]
        if (i == 1 || ratio < low) low = ratio
        if (i == 1 || ratio > high) high = ratio
    }
    return sprintf("%.2f to %.2f", low, high)
}

END {
    header = "| curve |"
    for (i = 1; i <= count; i++) header = header " " order[i] " |"
    print header
    print rule(count)
    for (i = 1; i <= places; i++) {
        line = "| " listed[i] " |"
        for (k = 1; k <= count; k++) line = line " " cell[order[k], listed[i]] " |"
        print line
    }
    grid = "start grid with allowance"
    front = "kept front with schedule"
    printf "\nIn words: the kept front with schedule takes %s times the median of the start grid with allowance and %s times its\n", \
        range(median, front, grid), range(p99, front, grid)
    printf "99th percentile. Without schedule and allowance it takes %s times the median of the start grid and %s times its 99th\n", \
        range(median, "kept front", "start grid"), range(p99, "kept front", "start grid")
    print "percentile."
    for (i = 1; i <= places; i++)
        if (hits["start grid", listed[i]] != hits["kept front", listed[i]])
            printf "Hits differ on the %s: %d from the top, %d from the start grid, %d of the kept front.\n", listed[i], \
                hits["from the top", listed[i]], hits["start grid", listed[i]], hits["kept front", listed[i]]
}
