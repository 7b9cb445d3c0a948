# set,detector,setting,f,precision,recall,best_f,ms

NR == 1 { next }

$1 != set {
    if (set) print ""
    set = $1
    print "| " set ": detector | setting | F automatic | precision | recall | F best of a sweep | ms |"
    print "|---|---|---:|---:|---:|---:|---:|"
}

{
    printf "| %s | %s | %s | %s | %s | %s | %s |\n", $2, $3, $4, $5, $6, $7, $8
    if ($2 ~ /^Touchline/) {
        if ($3 == "as built" && $2 ~ /edges/) { ours[set] = $4; ours_ms[set] = $8; ours_best[set] = $7 }
    } else if ($2 !~ /slot/ && $4 > other[set]) {
        other[set] = $4
        other_name[set] = $2 ", " $3
        other_ms[set] = $8
    }
    if (!(set in seen)) { seen[set]; sets[++count] = set }
}

END {
    print ""
    for (i = 1; i <= count; ++i) {
        set = sets[i]
        printf "In words, %s: as built, with nothing set by hand, F is %s in %s ms (%s at the best threshold); the best of the others, %s,\nhas %s in %s ms.\n", \
            set, ours[set], ours_ms[set], ours_best[set], other_name[set], other[set], other_ms[set]
    }
    print "Measured " machine "."
}
