# Torture geometry: what the shipped loop does there, in words; by all methods (table "methods"); and runs by scenario,
# method, stiffness and delay (summary). Set methods and summary with awk -v.

FNR > 2 {
    g = field("group"); m = field("method"); d = field("delay_periods"); a = field("asked")
    is_through = field("let_through") > 0
    is_over = field("generated_J") > field("bound_J") + 1e-9
    is_cut = field("least_gain") < 1
    buzz = field("buzzes")
    remember(g)
    if (!(m in is_known)) { is_known[m] = 1; names[++methods_count] = m }

    all_runs[m, a]++; all_through[m, a] += is_through; all_buzz[m, a] += buzz
    all_over[m, a] += is_over; all_cut[m, a] += is_cut; late_buzz[m, a] += buzz && d == 2
    group_runs[g, m]++; group_through[g, m] += is_through; group_buzz[g, m] += buzz

    row = g "," field("scenario") "," m "," a "," d
    if (!(row in n)) rows[++row_count] = row
    n[row]++; through[row] += is_through; buzzing[row] += buzz; over[row] += is_over; cut[row] += is_cut

    if (m != "shipped") next
    if (field("ripple_N") > 0.02 && field("extent_steps") > ring) ring = field("extent_steps")
    if (a != 1 || d == 2) next
    prompt++
    prompt_cut += is_cut
    by_nobody += is_cut && field("hand") == "none"
}

function verdict(g, m,    words) {
    if (!((g, m) in group_runs)) return " - |"
    if (group_through[g, m]) words = "through " group_through[g, m]
    if (group_buzz[g, m]) words = words (words ? ", " : "") "buzzes " group_buzz[g, m]
    return " " (words ? words : "stable") " |"
}

function both(counts, m) { return counts[m, 1] + counts[m, 2] }

END {
    s = "shipped"
    printf "In words: %d runs at the default stiffness and as many with twice as much asked for, without delay and with one and two\n", all_runs[s, 1]
    printf "periods of it. %d let through; %d ring at rest, the largest by %.1f encoder steps; %d give more energy than the bound. With up\n", both(all_through, s), both(all_buzz, s), ring, both(all_over, s)
    printf "to a period of delay the monitor cut in %d of %d runs at the default stiffness, %d of them a device that nobody holds; with\n", prompt_cut, prompt, by_nobody
    printf "two periods too in %d, and in %d of those with twice as much asked for.\n", all_cut[s, 1], all_cut[s, 2]
    printf "| runs that fail |" > methods
    for (k = 1; k <= methods_count; k++) printf " %s |", names[k] > methods
    printf "\n|---|" > methods
    for (k = 1; k <= methods_count; k++) printf "---|" > methods
    print "" > methods
    for (i = 1; i <= count; i++) {
        printf "| %s, of %d |", order[i], group_runs[order[i], s] > methods
        for (k = 1; k <= methods_count; k++) printf "%s", verdict(order[i], names[k]) > methods
        print "" > methods
    }
    p = "penalty"; x = "plain proxy"; y = "plain proxy + damping"; l = "local model"
    printf "\nIn words, at the default stiffness and at twice it: penalty forces let the hand through in %d and %d of %d runs: they do not know\n", all_through[p, 1], all_through[p, 2], all_runs[p, 1] > methods
    printf "where it came from. They alone give more energy than the bound, in %d. The plain proxy lets none through, so memory is what\n", both(all_over, p) + both(all_over, "penalty + damping") > methods
    printf "holds a line; but it buzzes in %d and %d, damped in %d and %d, of which %d with two periods of delay. The local model buzzes in\n", all_buzz[x, 1], all_buzz[x, 2], all_buzz[y, 1], all_buzz[y, 2], late_buzz[y, 1] + late_buzz[y, 2] > methods
    printf "%d: it runs at 4 kHz. It is let through %d gaps that a point fits in and a disc does not. Shipped: %d and %d.\n", both(all_buzz, l), both(all_through, l), both(all_through, s), both(all_buzz, s) > methods

    print "# The same on every machine: tests/lab/stability/run" > summary
    print "group,scenario,method,asked,delay_periods,runs,let_through,buzzing,over_bound,cut" > summary
    for (i = 1; i <= row_count; i++) { r = rows[i]; print r "," n[r] "," through[r] "," buzzing[r] "," over[r] "," cut[r] > summary }
}
