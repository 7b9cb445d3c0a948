# How far a proxy may slide in a tick, against error.

FNR > 2 && field("series") == "walks" {
    most = field("value")
    remember(most)
    key = most " " field("curve") " " field("edges")
    cell[key] = sprintf("%s / %s | %.3f | %.3f", short(field("p99_ns")), short(field("max_ns")), field("force_error_rms_N"), \
        field("place_error_rms_mm"))
    place[key] = field("place_error_rms_mm")
}

function cells_of(key) { return (key in cell) ? cell[key] : "- | - | -" }

function name(most) { return most > 1e6 ? "no limit" : most (most == 256 ? " (shipped)" : "") }

END {
    print "| edges a tick, at most | radial 65536: p99 / max (ns) | force (N, RMS) | place (mm, RMS) | radial 1048576: p99 / max (ns)" \
        " | force (N, RMS) | place (mm, RMS) | fractal 65536: p99 / max (ns) | force (N, RMS) | place (mm, RMS) |"
    print rule(9)
    for (i = 1; i <= count; ++i)
        print "| " name(order[i]) " | " cells_of(order[i] " radial 65536") " | " cells_of(order[i] " radial 1048576") " | " \
            cells_of(order[i] " fractal 65536") " |"
    printf "\nIn words: with at most 256 edges in a tick the proxy is off by %.3f mm (RMS) on the radial curve of 65536 edges, and by %.3f on\n", \
        place["256 radial 65536"], place["256 radial 1048576"]
    print "that of a million. Measured " machine "."
}
