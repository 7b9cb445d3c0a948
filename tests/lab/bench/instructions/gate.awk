# Reads the recorded figures, then the counted ones, "LEVEL EDGES INSTRUCTIONS" or "CLASS SIZE INSTRUCTIONS" a line; says
# how they differ.
# Exit status 1 where one grew by more than 5 % or is on one side only.

BEGIN { most = 5.0 }

/^#/ || NF == 0 { next }

NR == FNR {
    recorded[$1 " " $2] = $3
    next
}

{
    row = $1 " " $2
    counted[row] = 1
    if (!(row in recorded)) {
        print row ": nothing is recorded"
        faults++
        next
    }
    change = 100 * ($3 / recorded[row] - 1)
    verdict = "as recorded"
    if (change > most) {
        verdict = "too many"
        faults++
    } else if (change < -most) {
        verdict = "fewer"
        shrunk++
    }
    printf "%s: %.1f instructions, %.1f recorded, %+.2f %%: %s\n", row, $3, recorded[row], change, verdict
}

END {
    for (row in recorded)
        if (!(row in counted)) {
            print row ": recorded, but not counted"
            faults++
        }
    if (NR == FNR) faults++
    if (shrunk || faults) print "If this is meant, record the new figures with tests/lab/bench/instructions/record"
    exit faults > 0
}
