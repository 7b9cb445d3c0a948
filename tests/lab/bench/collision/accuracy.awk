# Levels, budgets of boxes and budgets of walks against error.

FNR > 2 && field("series") == "walks" {
    key = field("value") " " field("curve") " " field("edges")
    walk[key] = sprintf("%s / %s | %.3f | %.3f", short(field("p99_ns")), short(field("max_ns")), field("force_error_rms_N"), \
        field("place_error_rms_mm"))
    walk_place[key] = field("place_error_rms_mm")
    if (!(field("value") in is_walk)) walks[++walk_count] = field("value")
    is_walk[field("value")] = 1
    next
}

FNR > 2 {
    key = field("series") " " field("value") " " field("curve")
    p99[key] = field("p99_ns")
    rms[key] = field("force_error_rms_N")
    place[key] = field("place_error_rms_mm")
    slips[key] = field("slip_offs")
    if (field("series") == "level" && field("value") + 0 > coarsest[field("curve")] + 0) coarsest[field("curve")] = field("value") + 0
    edges = field("edges")
    remember(field("series") " " field("value"))
}

function sentences(curve,    level, last, fastest, k, exact) {
    exact = "level 0 " curve
    last = "level " coarsest[curve] " " curve
    printf "On the %s curve of %d edges 99 of 100 steps take less than %s ns at level 0 and %s at the coarsest level, whose force is\n", \
        curve, edges, short(p99[exact]), short(p99[last])
    printf "off by %.2f N and whose proxy is off by %.2f mm (RMS).\n", rms[last], place[last]
    for (k = 1; k <= 512; k *= 2)
        if (("budget " k " " curve in rms) && rms["budget " k " " curve] < 0.01) break
    if (k > 512) printf "No budget tried, up to 512 boxes, keeps the force within 0.01 N. "
    else printf "A budget of %d boxes keeps the force within 0.01 N and the step below %s ns (p99). ", k, short(p99["budget " k " " curve])
    k = 4
    printf "One of %d boxes gives %s ns and is\noff by %.2f N; the hand slips off %d times, %d times without a budget.\n", k, short(p99["budget " k " " curve]), \
        rms["budget " k " " curve], slips["budget " k " " curve], slips[exact]
}

# p99, error of force and of place of a setting on a curve, three cells.
function cells_of(setting, curve,    key) {
    key = setting " " curve
    return (key in p99) ? sprintf(" %s | %.2f | %.2f |", short(p99[key]), rms[key], place[key]) : " - | - | - |"
}

function title(setting) {
    sub(/^budget /, "boxes at most ", setting)
    return setting
}

function table_of_settings(    k) {
    print "| setting | radial: p99 (ns) | force (N, RMS) | place (mm, RMS) | fractal: p99 (ns) | force (N, RMS) | place (mm, RMS) |"
    print rule(6)
    for (k = 1; k <= count; ++k) print "| " title(order[k]) " |" cells_of(order[k], "radial") cells_of(order[k], "fractal")
    print ""
}

function table_of_walks(    k, most) {
    print "| edges slid along in a tick, at most | radial 65536: p99 / max (ns) | force (N, RMS) | place (mm, RMS) | radial 1048576: p99 / max (ns)" \
        " | force (N, RMS) | place (mm, RMS) | fractal 65536: p99 / max (ns) | force (N, RMS) | place (mm, RMS) |"
    print rule(9)
    for (k = 1; k <= walk_count; ++k) {
        most = walks[k]
        print "| " (most > 1e6 ? "no limit" : most (most == 256 ? " (shipped)" : "")) " | " walk_cells(most " radial 65536") " | " \
            walk_cells(most " radial 1048576") " | " walk_cells(most " fractal 65536") " |"
    }
}

function walk_cells(key) { return (key in walk) ? walk[key] : "- | - | -" }

END {
    table_of_settings()
    sentences("radial")
    sentences("fractal")
    print ""
    table_of_walks()
    printf "\nIn words: with at most 256 edges in a tick the proxy is off by %.3f mm (RMS) on the radial curve of 65536 edges and by %.3f on that of\n", \
        walk_place["256 radial 65536"], walk_place["256 radial 1048576"]
    print "a million, where two runs that slip off at different times are in different places; what a tick leaves is gone along in the next."
}
