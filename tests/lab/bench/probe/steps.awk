# Median / 99th percentile / maximum of a step: edges of the shape down, edges of the scene across.

FNR > 2 {
    shape = field("shape_edges") == 0 ? "a point (the point proxy)" : field("shape_edges") " edges"
    row = field("curve") ", level " (field("level") == "auto" ? "by speed" : field("level")) ", " shape
    remember(row)
    sizes[field("scene_edges")] = 1
    cell[row, field("scene_edges")] = short(field("median_ns")) " / " short(field("p99_ns")) " / " short(field("max_ns"))
    if (field("curve") == "radial" && field("shape_edges") == 64 && field("scene_edges") == 65536 && field("level") == "auto") {
        median_us = field("median_ns") / 1000
        p99_us = field("p99_ns") / 1000
        boxes = field("most_boxes")
    }
}

END {
    curve = "Nanoseconds of a step on a"
    print head_of_sizes()
    print rule(columns)
    for (i = 1; i <= count; i++) print row_of_sizes(order[i])
    printf "\nMeasured %s.\n\nIn words: with 64 edges in the hand, on a radial curve of 65536 edges and the level by speed, half of the steps take less than\n", machine
    printf "%.1f us (bar 5: %s) and 99 of 100 less than %.0f us (bar 30: %s); no step opens more than %d boxes.\n", median_us, \
        median_us <= 5 ? "met" : "missed", p99_us, p99_us <= 30 ? "met" : "missed", boxes
}
