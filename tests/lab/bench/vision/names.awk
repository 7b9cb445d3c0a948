# set,looks,higher,pictures,nameable,others,own,general,wrong,named,named_by_own,others_named,ms

function percent(part, all) { return sprintf("%d of %d (%.0f %%)", part, all, 100 * part / all) }

function row(title, looks, of) {
    printf "| %s, %d | %s | %d | %d | %d | %.1f | %s | %s | %d of %d | %s |\n", title, of["pictures"], looks, of["own"], of["general"], of["wrong"], \
        100 * of["wrong"] / of["pictures"], percent(of["named"], of["nameable"]), percent(of["named_by_own"], of["nameable"]), \
        of["others_named"], of["others"], of["ms"]
}

NR == 1 {
    for (i = 1; i <= NF; i++) column[i] = $i
    print "| pictures | looks | own words, right | \"an animal\", \"a vehicle\", right | wrong | wrong in 100 pictures | nameable ones named | by the thing's own word | other animals and vehicles, as such | ms, median |"
    print "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
    next
}

$3 == 0 {
    for (i = 4; i <= NF; i++) {
        set[column[i]] = $i
        all[$2, column[i]] += $i
    }
    row($1, $2, set)
}

END {
    for (looks = 1; looks <= 2; looks++) {
        for (i = 4; i <= NF; i++) set[column[i]] = all[looks, column[i]]
        set["ms"] = "-"
        row("all", looks, set)
    }
    printf "\nIn words: as it ships, with two looks, %.1f words in 100 pictures are wrong, and %.0f %% of the pictures that show something nameable are named,", \
        100 * set["wrong"] / set["pictures"], 100 * set["named"] / set["nameable"]
    printf "\n%.0f %% by its own word. Measured %s.\n", 100 * set["named_by_own"] / set["nameable"], machine
}
