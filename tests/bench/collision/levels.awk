# What the level by speed renders, and how far its force is from that of level 0.

FNR > 2 && field("row") == "Touchline level auto" {
    if (!lines++) {
        print "| curve, edges | spacing rendered, median (mm) | force from level 0, RMS (N) | largest (N) | steps coarser than the rule's level |"
        print rule(4)
    }
    printf "| %s %d | %.4f | %.3f | %.2f | %d of %d |\n", field("curve"), field("edges"), field("spacing_mm"), \
        field("force_error_rms_N"), field("force_error_max_N"), field("coarser_steps"), field("steps")
}

END {
    print "\nIn words: a step is rendered coarser than the rule asks while the proxy touches a line, since the level changes only where"
    print "it is free. After a slip-off the two runs are in different places, so that their forces differ by newtons."
}
