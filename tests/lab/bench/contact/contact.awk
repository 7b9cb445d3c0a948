# What each renderer does on hard geometry: let through, hung and largest jump by group.

FNR > 2 {
    row = field("row")
    group = field("group")
    remember(row)
    if (!(group in has_group)) groups[++group_count] = group
    has_group[group] = 1
    key = row SUBSEP group
    runs[key]++
    through[key] += field("let_through") > 0
    if (field("hung") != "") { hung[key] += field("hung"); is_judged[key] = 1 }
    if (field("max_jump_N") > jump[key]) jump[key] = field("max_jump_N")
    row_through[row] += field("let_through") > 0
    row_runs[row]++
}

END {
    line = "| let through (runs) / hung (ticks) / largest jump (N a tick) |"
    for (k = 1; k <= group_count; k++) line = line " " groups[k] " |"
    print line
    print rule(group_count)
    for (i = 1; i <= count; i++) {
        line = "| " order[i] " |"
        for (k = 1; k <= group_count; k++) {
            key = order[i] SUBSEP groups[k]
            if (!(key in runs)) line = line " - |"
            else line = line sprintf(" %d of %d / %s / %.2f |", through[key], runs[key], \
                (key in is_judged) ? hung[key] + 0 : "-", jump[key])
        }
        print line
    }
    printf "\nIn words:"
    for (i = 1; i <= count; i++)
        printf " %s: %d of %d runs let through%s", order[i], row_through[order[i]], row_runs[order[i]], i < count ? ";" : ".\n"
}
