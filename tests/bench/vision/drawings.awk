# kind,drawings,refused,seen_m,felt_share,too_near_share,too_short_share,seen_share,ms; `before` is a file of the same

NR == 1 {
    while ((getline line < before) > 0) {
        split(line, f, ",")
        felt[f[1]] = f[5]
        seen[f[1]] = f[8]
        ms[f[1]] = f[9]
    }
    print "| kind | drawings | of what is seen, felt | of what is felt, seen | left to the tactile rules: too near, too short | median | before: felt, seen, median |"
    print "|---|---:|---:|---:|---:|---:|---:|"
    next
}

function percent(share) { return sprintf("%.1f %%", 100 * share) }

{
    printf "| %s | %d | %s | %s | %s, %s | %d ms | %s, %s, %d ms |\n", $1, $2, percent($5), percent($8), percent($6), percent($7), $9,
        percent(felt[$1]), percent(seen[$1]), ms[$1]
    if (NR == 2 || $5 < least) { least = $5; worst = $1 }
    refused += $3
}

END {
    printf "\nIn words: of the kind where least is felt, %s, %s of what can be seen is felt within half a millimetre; %d drawings were refused.\n",
        worst, percent(least), refused
    printf "Measured %s.\n", machine
}
