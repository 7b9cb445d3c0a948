# From the checklist's ids and what ctest printed to a table: id, clause, tests, result.
BEGIN {
    FS = " \\| "
    site["IN-10"] = 1
    while ((getline line < log_file) > 0) {
        if (!match(line, /[.](SP|VO|IN|VI|TI|ER|LA|HA)[0-9]+_[A-Za-z0-9_]+/)) continue
        if (line !~ /Test +#/) continue
        id = substr(line, RSTART + 1, RLENGTH - 1)
        sub(/_.*/, "", id)
        count[id]++
        if (line !~ /Passed/) failed[id]++
    }
    print "| id | clause | in short | tests | result |"
    print "|---|---|---|---|---|"
}
/^#/ { next }
{
    id = $1
    key = id
    gsub(/-/, "", key)
    tests = count[key] + 0
    result = failed[key] ? "failed" : tests ? "passed" : site[id] ? "at the site" : "no test"
    printf "| %s | %s | %s | %s | %s |\n", id, $2, $3, tests, result
}
