# way,pictures,mean,median,sure,ring_sure,ring_unsure,ms,MB,felt_sure,felt_unsure; the last two where they were measured

# of(way): in words.
function of(way) {
    if (way == "grabcut") return "colours alone (GrabCut)"
    if (way == "small") return "small network, ships"
    return "restricted network, " way " x " way
}

NR == 1 {
    print "| way | mean overlap | median | sure of | ring on a boundary, where sure | where not | a picture | memory |"
    print "|:---|---:|---:|---:|---:|---:|---:|---:|"
    next
}

{
    printf "| %s | %.3f | %.3f | %d of %d | %.1f %% | %.1f %% | %.2f s | %d MB |\n", of($1), $3, $4, $5, $2, 100 * $6, 100 * $7, $8 / 1000, $9
    mean[$1] = $3
    if ($1 ~ /^[0-9]/ && $3 > best) { best = $3; said = sprintf("%.3f at %d pixels a side, in %.1f s", $3, $1, $8 / 1000) }
    if ($1 == "small") small = sprintf("%.3f in %.2f s", $3, $8 / 1000)
    if ($1 == "grabcut") colours = sprintf("%.3f", $3)
}

END {
    printf "\nIn words: the masks of the restricted network agree with people best, by %s. The small network that ships", said
    printf " reaches %s; colours alone reach %s. Measured %s.\n", small, colours, machine
}
