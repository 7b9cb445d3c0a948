# What a coarse encoder costs, by friction.

FNR > 2 {
    key = field("method") SUBSEP field("coulomb_N") SUBSEP field("encoder_um")
    k[key] = field("limit_N_per_m")
    ripple[key] = field("ripple_N")
    if (field("method") == "spring" && field("quantiser_N_per_m") != "inf") {
        above += field("limit_N_per_m") > field("quantiser_N_per_m")
        cells++
    }
}

function at(m, f, d) { return k[m SUBSEP f SUBSEP d] }

END {
    print "| largest K, N/m | no encoder step | 20 um | 41 um | 102 um |"
    print "|---|---:|---:|---:|---:|"
    for (m = 1; m <= 2; m++) {
        name = m == 1 ? "spring" : "spring + FOAW16"
        split("0 0.02 0.05 0.15", friction, " ")
        for (i = 1; i <= 4; i++) {
            f = friction[i]
            printf "| %s, friction %s N | %.0f | %.0f | %.0f | %.0f |\n", name, f, at(name, f, 0), at(name, f, 20), at(name, f, 41), at(name, f, 102)
        }
    }
    n = "spring + FOAW16"
    printf "\nIn words: %d of %d quantised spring cells come to rest above 2 f_c/Delta. That limit is for a hand that moves in step with\n", above, cells
    printf "the sampling; a hand that only holds does not. Friction decides: with 0.15 N the damped spring keeps %.0f %% of its stiffness\n", 100 * at(n, 0.15, 102) / at(n, 0.15, 0)
    printf "at 102 um, with 0.02 N %.0f %%, with none %.0f %%.\n", 100 * at(n, 0.02, 102) / at(n, 0.02, 0), 100 * at(n, 0, 102) / at(n, 0, 0)
}
