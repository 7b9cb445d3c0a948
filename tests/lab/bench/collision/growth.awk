# Building against size.

FNR > 2 {
    edges = field("edges")
    remember(edges)
    cell[field("curve"), edges] = sprintf("%.1f + %.1f | %.1f", field("curves_ms"), field("tree_ms"), field("scene_bytes_per_edge"))
    per_million[field("curve")] = field("scene_s_per_million_edges")
    bytes[field("curve")] = field("scene_bytes_per_edge")
}

END {
    print "| edges | radial: curves + tree (ms) | bytes an edge | fractal: curves + tree (ms) | bytes an edge |"
    print rule(4)
    for (i = 1; i <= count; ++i)
        if (i % 2 == 1 || i == count)
            print "| " order[i] " | " cell["radial", order[i]] " | " cell["fractal", order[i]] " |"
    printf "\nIn words: the largest radial curve is built at %.2f s a million edges, the fractal at %.2f (aim: 0.15); they hold %.1f and\n", \
        per_million["radial"], per_million["fractal"], bytes["radial"]
    printf "%.1f bytes an edge (aim: 40). Memory came in large pages here (`GLIBC_TUNABLES=glibc.malloc.hugetlb=1`), and in\n", bytes["fractal"]
    print "ordinary ones where the queries were measured, which is why building took longer there."
}
