# kind,drawings,refused,seen_m,felt_share,too_near_share,too_short_share,seen_share,ms
# of drawings_before.csv (-v before=FILE) and of drawings.csv

BEGIN {
    while ((getline line < before) > 0) {
        split(line, old, ",")
        felt_before[old[1]] = old[5]
        seen_before[old[1]] = old[8]
        refused_before += old[3]
    }
}

NR == 1 {
    print "| kind | drawings | of what is seen, felt: before, now | of what is felt, seen: before, now | left to the tactile rules: too near, too short | file to map, median |"
    print "|---|---:|---:|---:|---:|---:|"
    next
}

function percent(share) { return sprintf("%.2f %%", 100 * share) }

{
    printf "| %s | %d | %s, %s | %s, %s | %s, %s | %d ms |\n", $1, $2, percent(felt_before[$1]), percent($5),
        percent(seen_before[$1]), percent($8), percent($6), percent($7), $9
    if (NR == 2 || $5 < least) { least = $5; worst = $1 }
    refused += $3
}

END {
    printf "\nIn words: of the kind where least is felt, %s, %s of what can be seen is felt within half a millimetre (%s before); %d drawings were refused (%d before).\n",
        worst, percent(least), percent(felt_before[worst]), refused, refused_before
    printf "Measured %s.\n", machine
}
