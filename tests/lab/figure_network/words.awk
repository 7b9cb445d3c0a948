# step,hours,side,loss,held_out,marked
NR > 1 { hours = $2; steps = $1; if ($6 != "nan") { if (first == "") { first = $6; at = $2 } last = $6 } composed = $5 }

END {
    printf "In words: after %.2f hours the network alone overlaps with held-out photographs by %.2f, after %.2f hours and %d steps by %.2f;", at, first, hours, steps, last
    printf " with composed pictures, which are harder, by %.2f.\n", composed
}
