# megapixels,rms_mm,hausdorff_mm,ms

NR == 1 {
    print "| working picture | RMS at the handle | Hausdorff at the handle | pixels to lines |"
    print "|---:|---:|---:|---:|"
    next
}

{
    printf "| %s MP | %s mm | %s mm | %s ms |\n", $1, $2, $3, $4
    if (NR == 2) first = $3 " mm in " $4 " ms at " $1 " MP"
    last = $3 " mm in " $4 " ms at " $1 " MP"
}

END { printf "\nIn words: the farthest point of a letter is off by %s, by %s.\n", first, last }
