# instructions.csv -> what to expect of a Raspberry Pi 5. After tests/lab/bench/collision/cells.awk. `maps`: the file of what was
# counted of pictures. `recorded`, `recorded_map`: those of what was counted on x86-64.

BEGIN {
    clock_Hz = 2.4e9  # published: tests/machines/arm64/README.md
    tick_s = 1e-3
    read_x86(recorded)
    read_x86(recorded_map)
    print "| servo step on the radial curve | arm64: instructions, mean / median / 99th percentile / maximum | x86-64: mean |" \
        " costliest step at 0.5 a clock | at 1.0 | half of the time at 0.5 |"
    print rule(5)
}

function read_x86(file,    line, word) {
    while ((getline line < file) > 0) {
        split(line, word, " ")
        x86[word[1], word[2]] = word[3]
    }
}

function seconds(instructions, per_clock) { return instructions / per_clock / clock_Hz }

# The rate in kHz at which the costliest step takes half of the time.
function rate_kHz(instructions, per_clock) { return 0.5 / seconds(instructions, per_clock) / 1000 }

FNR > 2 {
    most = field("max")
    there = x86[field("level"), field("edges")]
    printf "| level %s, %d edges | %.0f / %d / %d / %d | %.0f | %.1f us | %.1f us | at %.0f kHz |\n", field("level"), field("edges"), \
        field("mean"), field("p50"), field("p99"), most, there, seconds(most, 0.5) * 1e6, seconds(most, 1) * 1e6, rate_kHz(most, 0.5)
    if (most > costliest) costliest = most
    if (!least || field("mean") / there < least) least = field("mean") / there
    if (field("mean") / there > largest) largest = field("mean") / there
}

END {
    print "\n| picture to map, detail 5, one processor | arm64: instructions | x86-64 | at 0.5 a clock | at 1.0 |"
    print rule(4)
    while ((getline line < maps) > 0) {
        split(line, word, ",")
        if (line ~ /^#/ || word[1] == "kind") continue
        printf "| %s, %s | %.2f G | %.2f G | %.1f s | %.1f s |\n", word[1], word[2], word[3] / 1e9, x86[word[1], word[2]] / 1e9, \
            seconds(word[3], 0.5), seconds(word[3], 1)
        if (word[3] > slowest) slowest = word[3]
    }
    printf "\nIn words: a step takes %.2f to %.2f times the instructions that it takes on x86-64. At half an instruction a clock the\n", \
        least, largest
    printf "costliest of all takes %.0f %% of a tick of 1 ms, and a picture\047s map %.1f s at the most.\nCounted %s.\n", \
        seconds(costliest, 0.5) / tick_s * 100, seconds(slowest, 0.5), machine
}
