# The shipped loop over its factorial, by device and period.

FNR > 2 {
    late = field("delay_periods") > 1
    runs[late]++
    shaking[late] += field("shakes")
    through += field("through")
    over += field("generated_J") > field("bound_J") + 1e-9
    if (late) next
    if (field("shakes")) which = which (which ? "; " : "") field("profile") ", " field("period_ms") " ms, delay " field("delay_periods") " T, hand " field("hand") ", fault " field("fault") ", " field("asked")
    p = field("profile"); T = field("period_ms"); a = field("asked")
    remember(p)
    key = p SUBSEP T SUBSEP a
    n[key]++
    cut[key] += field("least_gain") < 1
    k[key] = field("stiffness_N_per_m")
    if (field("fault") != "none") next
    quiet++
    quiet_cut += field("least_gain") < 1
    if (field("extent_um") / 1000 > worst[key]) worst[key] = field("extent_um") / 1000
    if (field("ripple_N") > ripple[key]) ripple[key] = field("ripple_N")
}

function entry(p, T, a,    key) {
    key = p SUBSEP T SUBSEP a
    return sprintf(" %.0f / %.2f / %.0f %% |", k[key], 1000 / k[key], 100 * cut[key] / n[key])
}

END {
    print "| K N/m / indentation at 1 N, mm / runs with a cut | 2 ms, default | 2 ms, stiffest | 1 ms, default | 1 ms, stiffest | 0.25 ms, default | 0.25 ms, stiffest |"
    print "|---|---|---|---|---|---|---|"
    for (i = 1; i <= count; i++) {
        p = order[i]
        print "| " p " |" entry(p, 2, "default") entry(p, 2, "stiffest") entry(p, 1, "default") entry(p, 1, "stiffest") \
            entry(p, 0.25, "default") entry(p, 0.25, "stiffest")
    }
    for (key in cut) {
        split(key, part, SUBSEP)
        group = part[2] == 0.25 && part[3] == "stiffest" ? "fast" : part[2] == 0.25 ? "quick" : "usual"
        cuts[group] += cut[key]
        all[group] += n[key]
    }
    printf "\nIn words: of %d runs with up to a period of delay %d shake, and of %d with two periods, which the loop does not know of,\n", runs[0], shaking[0], runs[1]
    printf "%d do. The proxy came through the wall in %d. More energy than the bound was given in %d. The monitor cuts in %.1f %% of\n", shaking[1], through, over, 100 * cuts["usual"] / all["usual"]
    printf "the runs at 1 and 2 ms, in %.0f %% at 0.25 ms with the default stiffness, in %.0f %% there with the largest allowed; of the %d\n", 100 * cuts["quick"] / all["quick"], 100 * cuts["fast"] / all["fast"], quiet
    printf "without faults in %.1f %%.\n", 100 * quiet_cut / quiet
    if (which) print "With up to a period of delay shakes: " which "."
}
