# Hands, rigid and through the skin.

FNR > 2 {
    key = field("method") SUBSEP field("hand") SUBSEP field("delay_periods")
    if (!(field("hand") in known)) { known[field("hand")] = 1; hands[++hand_count] = field("hand") }
    k[key] = field("limit_N_per_m")
    ratio = field("limit_N_per_m") / field("linear_N_per_m")
    m = field("method")
    if (least[m] == "" || ratio < least[m]) { least[m] = ratio; where[m] = field("hand") " at " field("delay_periods") " T" }
    if (lowest[m SUBSEP field("delay_periods")] == "" || k[key] + 0 < lowest[m SUBSEP field("delay_periods")] + 0) {
        lowest[m SUBSEP field("delay_periods")] = k[key]
        lowest_hand[m SUBSEP field("delay_periods")] = field("hand")
    }
}

END {
    print "| largest K at 1 kHz, N/m | spring, no delay | spring, delay T | FOAW16, no delay | FOAW16, delay T | FOAW16, delay 2 T |"
    print "|---|---:|---:|---:|---:|---:|"
    s = "spring"; f = "spring + FOAW16"
    for (i = 1; i <= hand_count; i++) {
        h = hands[i]
        printf "| %s | %.0f | %.0f | %.0f | %.0f | %.0f |\n", h, k[s SUBSEP h SUBSEP 0], k[s SUBSEP h SUBSEP 1], k[f SUBSEP h SUBSEP 0],
            k[f SUBSEP h SUBSEP 1], k[f SUBSEP h SUBSEP 2]
    }
    printf "\nIn words: undamped, the device alone is the worst, %.0f N/m at a period of delay; an arm behind a grip that damps little\n", k[s SUBSEP "none" SUBSEP 1]
    printf "stands %.0f where the same arm held rigidly stands %.0f. Virtual damping of 2 N s/m lifts the worst at a period of delay to\n",
        k[s SUBSEP "arm + bad skin" SUBSEP 1], k[s SUBSEP "relaxed arm" SUBSEP 1]
    printf "%.0f (%s). Counting the worse of skin and hand is safe for the bare spring: at least %.2f times (b + min)/(T/2 + t_d).\n",
        lowest[f SUBSEP 1], lowest_hand[f SUBSEP 1], least[s]
    printf "With B added it is %.2f at worst (%s): the sum wants a margin there.\n", least[f], where[f]
}
