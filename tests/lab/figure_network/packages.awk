# packages.tsv: package, version, licence, used for.

NR == 1 {
    print "| package | licence | used for |"
    print "|---|---|---|"
    next
}

{ printf "| %s %s | %s | %s |\n", $1, $2, $3, $4 }
