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
    print head_of_sizes() " build there, bytes an edge |"
    print rule(columns + 1)
    for (pass = 1; pass <= 2; pass++)
        for (i = 1; i <= count; i++) {
            if ((order[i] ~ /^crossing/) != (pass == 1)) continue
            print row_of_sizes(order[i]) " " build[order[i]] " |"
        }
    n = listed[columns]
    printf "\nIn words: for the first crossing at %d edges Touchline's tree takes %s ns (median), the grid %s, CGAL %s, Boost %s.\n", n, \
        short(median["crossing: Touchline", n]), short(median["crossing: uniform grid", n]), \
        short(median["crossing: AABB tree (CGAL)", n]), short(median["crossing: R-tree (Boost.Geometry)", n])
}
