# Whether budgets are kept.

FNR > 2 {
    if (!lines++) {
        print "| curve, edges | run | budget | steps | median / p99 / max (ns) | share within the budget | steps that it cut |"
        print rule(6)
    }
    printf "| %s %d | %s | %s | %d | %s / %s / %s | %.2f %% | %d |\n", field("curve"), field("edges"), field("row"), field("budget"), \
        field("steps"), short(field("median_ns")), short(field("p99_ns")), short(field("max_ns")), \
        100 * field("share_within_budget"), field("cut_steps")
    if (field("row") ~ /boxes/) {
        boxes += field("steps")
        kept += field("steps") * field("share_within_budget")
    } else if (!least || field("share_within_budget") < least) least = field("share_within_budget")
}

END {
    printf "\nIn words: %.3f %% of the steps with a budget of boxes opened no more than allowed. Of the steps with a deadline 10 us after\n", \
        100 * kept / boxes
    printf "their start, at least %.1f %% returned by then, in the worst of the rows. Each row is of one pass, in an ordinary process: its\n", 100 * least
    print "longest steps are those in which others had the processor."
}
