# kind,drawings,refused,seen_m,felt_share,too_near_share,too_short_share,seen_share,ms

NR == 1 {
    print "| kind | drawings | of what is seen, felt | of what is felt, seen | left to the tactile rules: too near, too short | file to map, median |"
    print "|---|---:|---:|---:|---:|---:|"
    next
}

function percent(share) { return sprintf("%.2f %%", 100 * share) }

{
    printf "| %s | %d | %s | %s | %s, %s | %d ms |\n", $1, $2, percent($5), percent($8), percent($6), percent($7), $9
    if (NR == 2 || $5 < least) { least = $5; worst = $1 }
    refused += $3
}

END {
    printf "\nIn words: of the kind where least is felt, %s, %s of what can be seen is felt within half a millimetre; %d drawings were refused.\n",
        worst, percent(least), refused
    printf "Measured %s.\n", machine
}
