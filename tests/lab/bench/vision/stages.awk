# stage,least_ms,median_ms

NR == 1 {
    print "| stage | least ms | median ms |"
    print "|---|---:|---:|"
    next
}

{
    printf "| %s | %s | %s |\n", $1, $2, $3
    last = $3
}

END { printf "\nIn words: the whole way takes %s ms of one core (median); at most 300 are wanted.\n", last }
