# Times of the servo steps on one curve.

FNR > 2 && field("group") == "step" && field("curve") == curve {
    name = field("row")
    edges = field("edges")
    remember(name)
    sizes[edges] = 1
    median[name, edges] = field("median_ns")
    p99[name, edges] = field("p99_ns")
    cell[name, edges] = short(field("median_ns")) " / " short(field("p99_ns")) " / " short(field("max_ns")) \
        (field("stopped") == "yes" ? " [" field("steps") "]" : "")
}

END {
    print head_of_sizes()
    print rule(columns)
    for (i = 1; i <= count; i++) print row_of_sizes(order[i])
    n = listed[columns]
    own = "Touchline level auto"
    exact = "Touchline level 0"
    grid = "plain proxy over uniform grid"
    printf "\nIn words: at %d edges half of Touchline's steps take less than %s ns and 99 of 100 less than %s ns with the level\n", \
        n, short(median[own, n]), short(p99[own, n])
    printf "by speed, %s and %s at level 0; the plain proxy over a grid takes %s and %s. By the 99th percentile Touchline with\n", \
        short(median[exact, n]), short(p99[exact, n]), short(median[grid, n]), short(p99[grid, n])
    printf "the level by speed is %s.\n", times(p99[grid, n] / p99[own, n])
    printf "By the 99th percentile the grid is faster than level 0 at %s edges, and than the level by speed at %s.\n", \
        slower_than_grid(exact), slower_than_grid(own)
    if (curve == "radial") check_grid()
}

# Medians of an independent program's grid and R-tree on the same work, 24 ns of each its timer, on another machine: the
# grid here must not be a weak one. The ratio of the R-trees stands for machine and compiler: it is the same structure.
function check_grid(    k, n, timer, tree, today) {
    split("102 159 246 718", other_grid, " ")
    split("605 984 2310 3155", other_tree, " ")
    match(machine, /own [0-9]+ ns/)
    timer = substr(machine, RSTART + 4) + 0
    tree = "plain proxy over R-tree (Boost.Geometry)"
    printf "\nIs the grid a good one? Its median beside that of an independent program on the same work, without the timers, after\n"
    printf "taking off how the R-tree, the same there and here, differs between the two:\n"
    for (k = 1; k <= columns; k++) {
        n = listed[k]
        today = (median[tree, n] - timer) / (other_tree[k] - 24)
        printf "%s%.2f at %d edges", (k > 1 ? ", " : ""), (median[grid, n] - timer) / (other_grid[k] - 24) / today, n
    }
    print ". At most 1.2 is wanted."
}

function slower_than_grid(name,    k, n, list) {
    for (k = 1; k <= columns; k++) {
        n = listed[k]
        if (p99[name, n] > p99[grid, n]) list = list (list == "" ? "" : ", ") n
    }
    return list == "" ? "no number of" : list
}

function times(ratio) {
    return ratio >= 1 ? sprintf("%.1f times as fast as the grid", ratio) : sprintf("%.1f times as slow as the grid", 1 / ratio)
}
