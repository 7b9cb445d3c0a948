# Methods at 1 kHz beside each other, and what delay and weak motors do to them.

FNR > 2 {
    key = field("method") SUBSEP field("hand") SUBSEP field("period_ms") SUBSEP field("delay_periods")
    if (field("motors_N") == "inf") {
        remember(field("method"))
        limit[key] = field("limit_N_per_m")
        step[key] = field("step_N")
        cells++
        passive_cells += field("passive_N_per_m") > 1
    } else
        weak[key] = field("limit_N_per_m")
    unstable += field("unstable_below")
}

function at(table, method, hand, delay) { return table[method SUBSEP hand SUBSEP 1 SUBSEP delay] }

END {
    print "| largest K at 1 kHz, N/m | alone, no delay | alone, delay T/2 | alone, delay T | light hand, no delay | light hand, delay T | largest force step, alone, N |"
    print "|---|---:|---:|---:|---:|---:|---:|"
    for (i = 1; i <= count; i++) {
        m = order[i]
        printf "| %s | %.0f | %.0f | %.0f | %.0f | %.0f | %.1f |\n", m, at(limit, m, "none", 0), at(limit, m, "none", 0.5),
            at(limit, m, "none", 1), at(limit, m, "light", 0), at(limit, m, "light", 1), at(step, m, "none", 0)
    }
    o = "energy observer"; f = "spring + FOAW16"; l = "local model"
    printf "\nIn words: a period of delay leaves the bare spring %.0f %% of its stiffness, the damped one %.0f %% and the energy\n",
        100 * at(limit, "spring", "none", 1) / at(limit, "spring", "none", 0), 100 * at(limit, f, "none", 1) / at(limit, f, "none", 0)
    printf "observer %.1f %%: the best without delay, with it no better than %.1f bare springs, and it pays with force steps of\n",
        100 * at(limit, o, "none", 1) / at(limit, o, "none", 0), at(limit, o, "none", 1) / at(limit, "spring", "none", 1)
    printf "%.0f N. The damped spring is the stiffest with delay on the device alone. With a hand the local model is, whose\n", at(step, o, "none", 0)
    printf "spring runs at four times the rate and is late by a period of its own: %.0f N/m", at(limit, l, "light", 1)
    printf ". Motors of 5 N change the limit of\nthe spring alone by %+.0f %%, the damped spring's by %+.0f %% and the\n",
        100 * (at(weak, "spring", "none", 0) / at(limit, "spring", "none", 0) - 1), 100 * (at(weak, f, "none", 0) / at(limit, f, "none", 0) - 1)
    printf "observer's by %+.0f %%. Search ends at 40 046 N/m. Of these %d cells %d have a limit of passivity; cells unstable below it: %d.\n",
        100 * (at(weak, o, "none", 0) / at(limit, o, "none", 0) - 1), cells, passive_cells, unstable
}
