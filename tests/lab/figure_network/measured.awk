# none.csv: way,pictures,claimed,sure; then figures.csv of tests/lab/bench/vision: way,pictures,mean,median,sure,ring_sure,
# ring_unsure,ms,MB and two more; then measured.csv: set,way and the same from pictures on, felt_sure,felt_unsure at the end.

# row(set, way, pictures, ...): one of the table.
function row(set, way, pictures, mean, median, sure, ring_sure, ring_unsure, felt_sure, felt_unsure, ms, mb) {
    printf "| %s | %s | %.3f | %.3f | %d | %.1f %% | %.1f %% | %s | %s | %d ms | %d MB |\n", \
        set == "hard" ? "[" pictures " hard ones](../bench/vision/photographs.md)" : pictures " held-out photographs", \
        way == "small" ? "small network" : way == "grabcut" ? "colours alone" : "restricted network", \
        mean, median, sure, 100 * ring_sure, 100 * ring_unsure, share(felt_sure), share(felt_unsure), ms, mb
}

function share(value) { return value == "" ? "not measured" : sprintf("%.1f %%", 100 * value) }

FNR == 1 { ++file; next }

file == 1 { claimed[$1] = $4; grounds = $2; next }

file == 2 { if ($1 == "768") restricted = $0; next }

FNR == 2 {
    print "| pictures | way | mean overlap | median | sure of | ring on the boundary, where sure | where not | as felt, where sure | where not | a picture | memory of the process |"
    print "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
}

{
    row($1, $2, $3, $4, $5, $6, $7, $8, $11, $12, $9, $10)
    has_hard = has_hard || $1 == "hard"
    memory[$1, $2] = $10
}

END {
    if (has_hard && restricted != "") {
        split(restricted, r)
        row("hard", r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[10], r[11], r[8], r[9])
    }
    printf "\nIn words: of %d held-out grounds without a main thing, the small network is sure of one in %d, colours alone in %d.", \
        grounds, claimed["small"], claimed["grabcut"]
    printf " Its process takes %d MB more than that of colours alone", memory["held_out", "small"] - memory["held_out", "grabcut"]
    if (has_hard) printf " with the held-out photographs, and %d MB more with the hard ones", memory["hard", "small"] - memory["hard", "grabcut"]
    print "."
}
