# none.csv: way,pictures,claimed,sure; then measured.csv: set,way,pictures,mean,median,sure,ring_sure,ring_unsure,ms,MB,
# felt_sure,felt_unsure

FNR == 1 { ++file; next }

file == 1 { claimed[$1] = $4; grounds = $2; next }

FNR == 2 {
    print "| pictures | way | mean overlap | median | sure of | ring on the boundary, where sure | where not | as felt, where sure | where not |"
    print "|---|---|---:|---:|---:|---:|---:|---:|---:|"
}

{
    of = $1 == "hard" ? "[" $3 " hard ones](../bench/vision/photographs.md)" : $3 " held-out photographs"
    printf "| %s | %s | %.3f | %.3f | %d | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", of, \
        $2 == "small" ? "small network" : "colours alone", $4, $5, $6, 100 * $7, 100 * $8, 100 * $11, 100 * $12
}

END {
    printf "\nIn words: of %d held-out grounds without a main thing, the small network is sure of one in %d, colours alone in %d.\n", \
        grounds, claimed["small"], claimed["grabcut"]
}
