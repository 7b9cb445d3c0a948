# The table of tests/lab/bench/naming from score.csv.
BEGIN {
    print "| picture | what it shows | said of its lines | | picked from the list | |"
    print "|---|---|---|---|---|---|"
}
{
    named += $4
    found += $6
    printf "| %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4 ? "right" : "wrong", $5, $6 ? "right" : "wrong"
}
END { printf "\nIn words: a reader named %d of %d, and picked %d from the list of all names. %s.\n", named, NR, found, date }
