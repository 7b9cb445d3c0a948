# Simulation against v*.

FNR > 2 {
    ratio = field("limit_N_per_m") / field("calmed_N_per_m")
    if (low == "" || ratio < low) low = ratio
    if (ratio > high) high = ratio
    k[field("coulomb_N") SUBSEP field("delay_periods") SUBSEP field("knock_m_per_s")] = field("limit_N_per_m")
    linear = field("linear_N_per_m")
}

END {
    printf "In words: friction of 0.05 N calms a knock of 0.1 m/s on a bare spring of up to %.0f N/m, of 0.4 m/s only up to %.0f;\n",
        k["0.05" SUBSEP 0 SUBSEP 0.1], k["0.05" SUBSEP 0 SUBSEP 0.4]
    printf "with a period of delay %.0f and %.0f. The formula K = (b + 4 f_c/(pi v))/(T/2 + t_d) is met within %.0f to %+.0f %%. So a wall that\n",
        k["0.05" SUBSEP 1 SUBSEP 0.1], k["0.05" SUBSEP 1 SUBSEP 0.4], 100 * (low - 1), 100 * (high - 1)
    print "seems sound under a gentle hand rings when it is hit: stable and passive are not the same."
}
