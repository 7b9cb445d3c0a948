# set,change,f

NR == 1 { next }

{
    if (!($1 in seen)) { seen[$1]; sets[++count] = $1 }
    if (!($2 in known)) { known[$2]; changes[++changed] = $2 }
    f[$1, $2] = $3
    if (least == "" || $3 < least) { least = $3; worst = $1 ", " $2 }
}

END {
    row = "| F between lines before and after |"
    rule = "|---|"
    for (i = 1; i <= changed; ++i) { row = row " " changes[i] " |"; rule = rule "---:|" }
    print row
    print rule
    for (s = 1; s <= count; ++s) {
        row = "| " sets[s] " |"
        for (i = 1; i <= changed; ++i) row = row " " f[sets[s], changes[i]] " |"
        print row
    }
    printf "\nIn words: the least is %s (%s); 0.80 must hold.\n", least, worst
}
