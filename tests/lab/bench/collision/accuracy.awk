# Levels and budgets of boxes against error.

FNR > 2 && field("series") != "walks" {
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

END {
    table_of_settings()
    sentences("radial")
    sentences("fractal")
    print "Measured " machine "."
}
