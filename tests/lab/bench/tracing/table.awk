# Numbers by way of tracing, from tracing.csv.
NR > 1 {
    if (!($1 in count)) order[++modes] = $1
    m = $1
    count[m]++
    traced[m] += $8
    named[m] += $9
    covered[m] += $7
    share[m] += $5 / $4
    if ($6 < 1000) {
        paths[m]++
        off[m] += $6
        if ($6 > worst[m]) worst[m] = $6
    }
    if (!(m in least) || $7 < least[m]) least[m] = $7
}

function title(m) {
    return m == "groove" ? "groove, by force" : m == "off" ? "the same hand, forces off" : m == "wall" ? "wall, by force" : "tour, a relaxed hand is led"
}

END {
    print "| | pictures traced | named rightly | 90 % of the path within, mean / worst | outline found, mean / least | time used of the limit |"
    print "|---|---|---|---|---|---|"
    for (i = 1; i <= modes; i++) {
        m = order[i]
        if (paths[m] > 0) path = sprintf("%.2f / %.2f mm", off[m] / paths[m], worst[m])
        else path = "no path"
        printf "| %s | %d of %d | %d of %d | %s | %.1f / %.1f %% | %.0f %% |\n", title(m), traced[m], count[m], named[m], count[m], path, 100 * covered[m] / count[m], 100 * least[m], 100 * share[m] / count[m]
    }
}
