# Best virtual damping by filter, period and delay.

FNR > 2 {
    key = field("method") SUBSEP field("period_ms") SUBSEP field("delay_periods")
    remember(field("method"))
    k = field("limit_N_per_m") + 0
    if (k > best[key]) { best[key] = k; at[key] = field("damping_Ns_per_m") }
    if (field("damping_Ns_per_m") == 2) two[key] = k
    if (field("damping_Ns_per_m") == 30) thirty[key] = k
    excess = field("exact_N_per_m") > 0 && field("method") != "spring + FOAW16" ? k / field("exact_N_per_m") - 1 : 0
    if (excess < least) least = excess
}

function entry(m, T, d,    key) {
    key = m SUBSEP T SUBSEP d
    return sprintf(" %.0f at %g; %.0f; %.0f |", best[key], at[key], two[key], thirty[key])
}

END {
    print "| K in N/m: best at its B; at B = 2; at B = 30 | 2 ms, no delay | 2 ms, delay T | 1 ms, no delay | 1 ms, delay T |"
    print "|---|---|---|---|---|"
    for (i = 1; i <= count; i++)
        print "| " order[i] " |" entry(order[i], 2, 0) entry(order[i], 2, 1) entry(order[i], 1, 0) entry(order[i], 1, 1)
    key = "spring + FOAW16" SUBSEP 2 SUBSEP 1
    printf "\nIn words: stiffness grows with virtual damping about as (b + B) only up to 2 N s/m, turns over near half the mass a\n"
    printf "period, and falls to nothing: with FOAW at 2 ms and a period of delay from %.0f N/m at B = %g to %.0f at 30. At B = 2 the\n", best[key], at[key], thirty[key]
    printf "three filters differ by less than %.0f %%. At large B the simulation is up to %.0f %% below the eigenvalues: an encoder of\n", spread(), -100 * least
    print "20 um times B/T is then a force that shakes the tip, which no linear theory sees."
}

function spread(    i, T, d, key, low, high, most) {
    for (T = 1; T <= 2; T++)
        for (d = 0; d <= 1; d++) {
            low = 1e9; high = 0
            for (i = 1; i <= count; i++) {
                key = order[i] SUBSEP T SUBSEP d
                if (two[key] < low) low = two[key]
                if (two[key] > high) high = two[key]
            }
            if (high / low - 1 > most) most = high / low - 1
        }
    return 100 * most + 1
}
