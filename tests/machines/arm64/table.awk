# instructions.csv -> what to expect of a Raspberry Pi 5. After tests/lab/bench/collision/cells.awk. `recorded`: the file of the
# means on x86-64.

BEGIN {
    clock_Hz = 2.4e9  # published: tests/machines/arm64/README.md
    tick_s = 1e-3
    while ((getline line < recorded) > 0) {
        split(line, word, " ")
        x86[word[1] " " word[2]] = word[3]
    }
}

function seconds(instructions, per_clock) { return instructions / per_clock / clock_Hz }

# The rate in kHz at which the costliest step takes half of the time.
function rate_kHz(instructions, per_clock) { return 0.5 / seconds(instructions, per_clock) / 1000 }

FNR > 2 && field("kind") == "step" {
    if (!steps++) {
        print "| servo step on the radial curve | arm64: instructions, mean / median / 99th percentile / maximum | x86-64: mean |" \
            " costliest step at 0.5 a clock | at 1.0 | half of the time at 0.5 |"
        print rule(5)
    }
    split(field("what"), word, " ")
    most = field("max")
    mean = x86[field("what")]
    printf "| level %s, %d edges | %.0f / %d / %d / %d | %.0f | %.1f us | %.1f us | at %.0f kHz |\n", word[1], word[2], \
        field("mean"), field("p50"), field("p99"), most, mean, seconds(most, 0.5) * 1e6, seconds(most, 1) * 1e6, rate_kHz(most, 0.5)
    if (most > costliest) costliest = most
    if (!least || field("mean") / mean < least) least = field("mean") / mean
    if (field("mean") / mean > largest) largest = field("mean") / mean
}

FNR > 2 && field("kind") == "map" {
    if (!maps++) {
        print "\n| picture to map, detail 5, one processor | x86-64 with vectors of 16 bytes: instructions | at 0.5 a clock | at 1.0 |"
        print rule(3)
    }
    printf "| %s | %.2f G | %.1f s | %.1f s |\n", field("what"), field("mean") / 1e9, seconds(field("mean"), 0.5), seconds(field("mean"), 1)
}

END {
    printf "\nIn words: a step takes %.2f to %.2f times the instructions that it takes on x86-64. At half an instruction a clock the\n", \
        least, largest
    printf "costliest of all takes %.0f %% of a tick of 1 ms.\nCounted %s.\n", seconds(costliest, 0.5) / tick_s * 100, machine
}
