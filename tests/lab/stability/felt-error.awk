# Total felt error against servo rate: indentation at 1 N, what the level leaves out, encoder step, and lag at
# 0.1 m/s over a period of delay. Reads the bench's speed_accuracy.csv (radial curve), then settings.csv. Writes
# felt-error.dat: profile, slower, rate_Hz, level (-1: the best of all), error_mm, and a line with level best at the slowest rate that is good enough. Set dat with awk -v.

FILENAME ~ /speed_accuracy/ && FNR > 2 {
    if (field("series") == "level" && field("curve") == "radial") {
        level = field("value")
        time_ns[level] = field("p99_ns")
        left_out_mm[level] = field("place_error_rms_mm")
        if (level > last) last = level
    }
    next
}

FNR > 2 {
    p = field("profile")
    if (p !~ /^(2diy-gen3.1|2diy-gen2|mk2)$/) next
    remember(p)
    rate = field("rate_Hz")
    floor_mm = 1000 / field("stiffness_N_per_m") + field("encoder_mm") + 100 * 1.5 / rate
    for (slower = 1; slower <= 100; slower *= 100) {
        best = 1e9
        for (level = 0; level <= last; level++) {
            if (time_ns[level] * slower * rate * 1e-9 > 0.3) continue
            error = floor_mm + left_out_mm[level]
            if (level == 0 || level == 1 || level == 2 || level == 4) print p "," slower "," rate "," level "," error > dat
            if (error < best) { best = error; best_level = level }
        }
        if (best > 1e8) continue
        print p "," slower "," rate ",-1," best > dat
        key = p SUBSEP slower
        if (!(key in least) || best < least[key]) least[key] = best
        rates[key]++
        at = key SUBSEP rates[key]
        rate_of[at] = rate
        best_of[at] = best
        level_of[at] = best_level
        soft_of[at] = 1000 / field("stiffness_N_per_m")
        if (rate > 990 && rate < 1010) usual[key] = best
    }
}

# The slowest rate that comes within 5 % of the least error.
function enough(key,    k) {
    for (k = 1; k <= rates[key]; k++)
        if (best_of[key SUBSEP k] <= 1.05 * least[key]) return key SUBSEP k
}

END {
    print "| felt error at 1 N and 0.1 m/s | at 1 kHz, mm | least, mm | within 5 % of it from, Hz | level there | of it indentation, mm |"
    print "|---|---:|---:|---:|---:|---:|"
    for (i = 1; i <= count; i++)
        for (slower = 1; slower <= 100; slower *= 100) {
            key = order[i] SUBSEP slower
            at = enough(key)
            printf "| %s, %s | %.2f | %.2f | %.0f | %d | %.2f |\n", order[i], slower == 1 ? "this computer" : "one 100 times slower", usual[key], least[key], rate_of[at], level_of[at], soft_of[at]
            print order[i] "," slower "," rate_of[at] ",best," best_of[at] > dat
        }
    f = order[1]; m = "mk2"
    here = enough(f SUBSEP 1); fine = enough(m SUBSEP 1); slow = enough(m SUBSEP 100)
    printf "\nIn words: rate buys accuracy only until something else holds the stiffness. The %s comes to %.2f mm at %.0f Hz, where\n", f, best_of[here], rate_of[here]
    printf "its encoder does; the mk2 to %.2f mm at %.0f Hz, where a stiffer wall would no longer be told apart. On a computer 100 times\n", best_of[fine], rate_of[fine]
    printf "slower the finest level costs so much time that the optimum is inside: level %d at %.0f Hz on the mk2, %.2f mm. A finer\n", level_of[slow], rate_of[slow], best_of[slow]
    print "level would want a slower loop and so a softer wall, a faster loop a coarser level."
}
