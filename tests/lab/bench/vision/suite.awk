# chapter,drawings,whole,felt_share,seen_share,left_share,refused,otherwise,blank

NR == 1 {
    print "| chapter | drawings | of these 99 % felt and 99 % seen | of what is seen, felt | of what is felt, seen | left to the tactile rules | painted otherwise | refused | nothing to see |"
    print "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
    next
}

function percent(share) { return sprintf("%.2f %%", 100 * share) }

{
    printf "| %s | %d | %d | %s | %s | %s | %d | %d | %d |\n", $1, $2, $3, percent($4), percent($5), percent($6), $8, $7, $9
    drawings += $2
    whole += $3
}

END {
    printf "\nIn words: of %d drawings that both programs paint alike, %d are felt as they are painted, 99 %% of them at least and nothing else.\n",
        drawings, whole
}
