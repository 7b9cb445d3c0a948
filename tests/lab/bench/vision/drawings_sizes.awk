# megapixels,felt_share,seen_share,ms

NR == 1 {
    print "| working picture | of what is seen, felt | of what is felt, seen | file to map |"
    print "|---:|---:|---:|---:|"
    next
}

{
    printf "| %s MP | %.1f %% | %.1f %% | %d ms |\n", $1, 100 * $2, 100 * $3, $4
    said = sprintf("%.1f %% in %d ms at %s MP", 100 * $2, $4, $1)
    if (NR == 2) first = said
}

END { printf "\nIn words: what can be seen is felt to %s, to %s.\n", first, said }
