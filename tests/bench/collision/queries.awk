# Times of single queries on one curve.

FNR > 2 && field("group") != "step" && field("curve") == curve {
    name = field("group") ": " field("row")
    edges = field("edges")
    remember(name)
    sizes[edges] = 1
    median[name, edges] = field("median_ns")
    cell[name, edges] = short(field("median_ns")) " / " short(field("p99_ns")) " / " short(field("max_ns")) \
        (field("stopped") == "yes" ? " [" field("steps") "]" : "")
    build[name] = sprintf("%.1f ms, %.0f", field("build_ms"), field("bytes_per_edge"))
}

# All crossings, then all nearest points.
END {
    header = "| " curve " curve |"
    for (n = 512; n <= 1048576; n *= 2)
        if (n in sizes) {
            header = header " " n " edges |"
            listed[++columns] = n
        }
    print header " build there, bytes an edge |"
    print rule(columns + 1)
    for (pass = 1; pass <= 2; pass++)
        for (i = 1; i <= count; i++) {
            if ((order[i] ~ /^crossing/) != (pass == 1)) continue
            line = "| " order[i] " |"
            for (k = 1; k <= columns; k++)
                line = line " " (((order[i], listed[k]) in cell) ? cell[order[i], listed[k]] : "-") " |"
            print line " " build[order[i]] " |"
        }
    n = listed[columns]
    printf "\nIn words: for the first crossing at %d edges Touchline's tree takes %s ns (median), the grid %s, CGAL %s, Boost %s.\n", n, \
        short(median["crossing: Touchline", n]), short(median["crossing: uniform grid", n]), \
        short(median["crossing: AABB tree (CGAL)", n]), short(median["crossing: R-tree (Boost.Geometry)", n])
}
