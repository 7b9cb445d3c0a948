# Processor time and memory, nobody here and in use, against the size of the screen.

FNR > 2 {
    size = field("width") " x " field("height")
    remember(size)
    share[size, $1] = field("share_percent")
    cell[size, $1] = sprintf("%.1f (%.1f) | %d (%d)", field("share_percent"), field("most_percent"), field("memory_MB"), field("most_MB"))
    load_of[size, $1] = field("load")
    percent = field("share_percent") + 0
    if (!($1 in largest) || percent > largest[$1]) { largest[$1] = percent; largest_size[$1] = size }
    if (field("most_MB") > most_MB) most_MB = field("most_MB")
}

END {
    print "| screen | nobody here, % of a core | MB | in use, % of a core | MB | load |"
    print rule(5)
    for (i = 1; i <= count; i++)
        printf "| %s | %s | %s | %.1f, %.1f |\n", order[i], cell[order[i], "idle"], cell[order[i], "in use"], load_of[order[i], "idle"], \
            load_of[order[i], "in use"]
    usual = "1280 x 800"
    printf "\nMedian (most). Measured %s.\n\nIn words: on %s the kiosk takes %.1f %% of a core while nobody is here (bar 3: %s) and %.1f %% in use (bar 35: %s);\n", \
        machine, usual, share[usual, "idle"], share[usual, "idle"] <= 3 ? "met" : "missed", share[usual, "in use"], \
        share[usual, "in use"] <= 35 ? "met" : "missed"
    printf "on the worst of these screens it takes %.1f %% (%s) and %.1f %% (%s: %s);\n", largest["idle"], largest_size["idle"], \
        largest["in use"], largest_size["in use"], largest["in use"] <= 35 ? "met" : "missed"
    printf "all processes together never hold more than %d MB on any of these screens (bar 250: %s).\n", most_MB, most_MB <= 250 ? "met" : "missed"
}
