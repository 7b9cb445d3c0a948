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
    if (curve == "radial") check_grid()
}

# Medians of an independent program's grid and CGAL tree on the same work, on a machine of the same kind: the grid
# here must not be a weak one. CGAL's ratio stands for how fast the machine is today.
function check_grid(    k, n, tree, today) {
    split("102 159 246 718", other_grid, " ")
    split("257 397 823 1077", other_tree, " ")
    tree = "plain proxy over AABB tree (CGAL)"
    printf "\nIs the grid a good one? Its median beside that of an independent program on the same work, after taking off how much\n"
    printf "slower CGAL is today:"
    for (k = 1; k <= columns; k++) {
        n = listed[k]
        today = median[tree, n] / other_tree[k]
        printf "%s %.2f at %d edges", (k > 1 ? "," : ""), median[grid, n] / other_grid[k] / today, n
    }
    print ". At most 1.2 is wanted."
}

function times(ratio) {
    return ratio >= 1 ? sprintf("%.1f times as fast as the grid", ratio) : sprintf("%.1f times as slow as the grid", 1 / ratio)
}
