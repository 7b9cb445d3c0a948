# What the hand felt on one curve: tunnel events or let-throughs, slip-offs, gap, jumps.

FNR > 2 && field("group") == "step" && field("curve") == curve {
    name = field("row")
    edges = field("edges")
    remember(name)
    sizes[edges] = 1
    through = field("let_through") == "" ? field("entered") : field("let_through")
    if (field("let_through") != "") own_through += through
    if (name == "Touchline level auto") own_slips += field("slip_offs")
    cell[name, edges] = through " / " field("slip_offs") " / " sprintf("%.1f", field("max_gap_mm")) " / " \
        sprintf("%.2f", field("max_jump_N_per_ms"))
}

END {
    print head_of_sizes()
    print rule(columns)
    for (i = 1; i <= count; i++) print row_of_sizes(order[i])
    printf "\nIn words: in all of Touchline's runs on this curve %s the line; with the level by speed\n", \
        own_through == 0 ? "no step went through" : own_through " steps went through"
    printf "the hand slipped off %d times in all.\n", own_slips
}
