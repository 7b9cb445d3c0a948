# Torture geometry through the shipped loop, by group and delay.

FNR > 2 {
    g = field("group")
    remember(g)
    key = g SUBSEP field("delay_periods")
    n[key]++
    through[key] += field("let_through") > 0
    if (field("extent_steps") > extent[key]) extent[key] = field("extent_steps")
    cut[key] += field("least_gain") < 1
    total++
    all_through += field("let_through") > 0
    ringing += field("extent_steps") > 2
    over += field("generated_J") > field("bound_J") + 1e-9
    cuts += field("least_gain") < 1
}

function entry(g, d,    key) {
    key = g SUBSEP d
    return sprintf(" %d of %d / %.2f / %d |", through[key], n[key], extent[key], cut[key])
}

END {
    bars = "thin bars" SUBSEP
    print "| let through / largest ring at rest, encoder steps / runs with a cut | no delay | delay T | delay 2 T |"
    print "|---|---|---|---|"
    for (i = 1; i <= count; i++) print "| " order[i] " |" entry(order[i], 0) entry(order[i], 1) entry(order[i], 2)
    printf "\nIn words: %d runs, each scenario with four hands and three delays: %d let through, %d ring at rest beyond two encoder steps,\n", total, all_through, ringing
    printf "%d give more energy than the bound; the monitor cut in %d, %d of them on thin bars, where the motors saturate.\n", over, cuts, cut[bars 0] + cut[bars 1] + cut[bars 2]
}
