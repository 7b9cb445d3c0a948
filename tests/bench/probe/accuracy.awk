# What a coarser level takes of the place, and what it saves.

FNR > 2 {
    row = field("curve") ", level " (field("level") == "auto" ? "by speed" : field("level"))
    remember(row)
    line[row] = sprintf("| %s | %s | %s | %s | %.2f | %.2f | %d |", row, field("spacing_mm") > 0 ? sprintf("%.3f", field("spacing_mm")) : "-", \
        short(field("median_ns")), short(field("p99_ns")), field("place_median_mm"), field("place_rms_mm"), field("slip_offs"))
    if (field("curve") == "radial") {
        p99[field("level")] = field("p99_ns") / 1000
        place[field("level")] = field("place_median_mm")
    }
}

END {
    print "| curve, level | spacing (mm) | median (ns) | p99 (ns) | place off, median (mm) | RMS (mm) | slip-offs |"
    print rule(6)
    for (i = 1; i <= count; i++) print line[order[i]]
    printf "\nIn words: on the radial curve 99 of 100 steps take less than %.0f us at level 0 and %.0f us with the level by speed, whose shape\n", p99["0"], p99["auto"]
    printf "is off by %.2f mm in half of the steps. After a slip-off the two runs are in different places, which the RMS counts.\n", place["auto"]
}
