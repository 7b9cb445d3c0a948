# What a small computer needs. After collision/cells.awk. The costliest step must be done within the period.

BEGIN {
    paper_MHz = 30  # the paper's handle controller: a T805 with floating point of its own
    paper_Hz = 500
}

# The lowest clock in MHz at which a step's instructions fit into a period.
function clock(instructions, per_clock, rate_Hz) { return instructions / per_clock * rate_Hz / 1e6 }

function name() { return "level " field("level") ", " field("edges") " edges" }

FNR > 2 {
    if (!rows++) {
        print "| radial curve | instructions a step: median / 99th percentile / maximum | cache lines a step: median / maximum" \
            " (code, data) | 500 Hz at 0.5 a clock | 500 Hz at 1.0 | 1 kHz at 0.5 | 1 kHz at 1.0 |"
        print rule(6)
    }
    most = field("max")
    printf "| %s | %d / %d / %d | %d / %d (%d, %d) | %.1f MHz | %.1f MHz | %.1f MHz | %.1f MHz |\n", name(), field("p50"), \
        field("p99"), most, field("lines_p50"), field("lines_max"), field("code_lines_max"), field("data_lines_max"), \
        clock(most, 0.5, 500), clock(most, 1, 500), clock(most, 0.5, 1000), clock(most, 1, 1000)
    needed[field("level") " " field("edges")] = clock(most, 0.5, paper_Hz)
    if (field("lines_max") > lines) lines = field("lines_max")
}

END {
    printf "\nIn words: the paper's handle controller, a transputer of %d MHz at %d Hz, has %d clocks a step. ", paper_MHz, paper_Hz, \
        paper_MHz * 1e6 / paper_Hz
    printf "At half an instruction a clock\nthe costliest step with the level by speed needs %.1f MHz on 512 edges and %.1f on 65536: %s.\n", \
        needed["auto 512"], needed["auto 65536"], \
        needed["auto 512"] <= paper_MHz && needed["auto 65536"] <= paper_MHz ? "it has them" : "more than it has"
    printf "No counted step touches more than %d cache lines, %.1f kB of code and data.\nCounted %s.\n", lines, lines * 64 / 1000, machine
}
