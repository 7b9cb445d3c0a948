# side,pictures,mean,median,sure,ring_sure,ring_unsure,ms,MB

NR == 1 {
    print "| picture for the network | mean overlap | median | sure of | ring on a boundary, where sure | where not | a picture | memory |"
    print "|---:|---:|---:|---:|---:|---:|---:|---:|"
    next
}

{
    printf "| %d x %d | %.3f | %.3f | %d of %d | %.1f %% | %.1f %% | %.1f s | %d MB |\n", $1, $1, $3, $4, $5, $2, 100 * $6, 100 * $7, $8 / 1000, $9
    if ($3 > best) { best = $3; said = sprintf("%.3f at %d pixels a side, in %.1f s", $3, $1, $8 / 1000) }
}

END { printf "\nIn words: the masks agree with people best, by %s. Measured %s.\n", said, machine }
