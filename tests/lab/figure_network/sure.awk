# set,way,name,overlap,ring,contrast, the greatest contrast of a set first: for each picture of the small network, how many
# of its set are as sure, in per cent, and the mean of their rings.
$2 != "small" { next }

{
    rows[$1] += 1
    rings[$1] += $5
    line[NR] = $1 "," rows[$1] "," 100 * rings[$1] / rows[$1]
    set[NR] = $1
}

END {
    for (row = 1; row <= NR; ++row) {
        if (!(row in line)) continue
        split(line[row], parts, ",")
        print parts[1] "," 100 * parts[2] / rows[set[row]] "," parts[3]
    }
}
