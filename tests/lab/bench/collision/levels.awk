# What the level by speed renders, and how far its force is from that of level 0.

FNR > 2 && field("row") == "Touchline level auto" {
    if (!lines++) {
        print "| curve, edges | spacing rendered, median (mm) | force from level 0, RMS (N) | largest (N) | steps coarser than the rule's level |"
        print rule(4)
    }
    printf "| %s %d | %.4f | %.3f | %.2f | %d of %d |\n", field("curve"), field("edges"), field("spacing_mm"), \
        field("force_error_rms_N"), field("force_error_max_N"), field("coarser_steps"), field("steps")
    share = field("coarser_steps") / field("steps")
    if (share > most_coarser) most_coarser = share
    if (field("curve") == "radial" && field("force_error_max_N") + 0 > most_error) most_error = field("force_error_max_N") + 0
}

END {
    printf "\nIn words: at most %.1f %% of the steps of a run are rendered coarser than the rule asks. The farthest force is off by\n", \
        100 * most_coarser
    printf "%.2f N on the radial curve. After a slip-off the two runs are in different places and their forces differ by newtons.\n", \
        most_error
}
