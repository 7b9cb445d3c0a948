# What readers said, as tables: pictures.csv and then each file of answers, named WAY-NUMBER.csv. What was said is right where a word
# of the name, or of what is also right, stands in it by itself.
function has(text, word) { return word != "" && (" " text " ") ~ (" " word "s?(es)? ") }
function plain(text) { text = tolower(text); gsub(/[^a-z ]+/, " ", text); return text }
function is_named(said, picture,    words, count, i) {
    count = split(right[picture], words, "|")
    for (i = 1; i <= count; i++) if (has(plain(said), plain(words[i]))) return 1
    return 0
}
# span(SUMS, WAY): the mean of a way's readers, and from which to which they go.
function span(sums, way,    reader, sum, least, most) {
    least = 1e9; most = sum = 0
    for (reader = 1; reader <= readers[way]; reader++) {
        sum += sums[way, reader]
        if (sums[way, reader] < least) least = sums[way, reader]
        if (sums[way, reader] > most) most = sums[way, reader]
    }
    return least == most ? least : sprintf("%.1f (%d to %d)", sum / readers[way], least, most)
}
BEGIN {
    split("restricted small colours", ways, " ")
    told["restricted"] = "the restricted network"
    told["small"] = "the small network, which ships"
    told["colours"] = "no network: edges and colours alone"
}
FNR == 1 {
    if (++part > 1) {
        way = FILENAME; sub(/.*\//, "", way); sub(/-[0-9]+\.csv$/, "", way)
        readers[way]++
    }
    next
}
part == 1 { pictures[++count] = $1; name[$1] = $3; right[$1] = $3 "|" $4; next }
{
    by_name = is_named($2, $1)
    by_list = $3 == name[$1]
    named[way, $1] += by_name
    all_named[way, readers[way]] += by_name
    all_picked[way, readers[way]] += by_list
    if (way == "small") said[$1] = said[$1] (said[$1] == "" ? "" : "; ") $2
}
END {
    print "| lines from | readers | named, of " count " | picked from the list |\n|---|---|---|---|"
    for (i = 1; i <= 3; i++)
        if (readers[ways[i]]) printf "| %s | %d | %s | %s |\n", told[ways[i]], readers[ways[i]], span(all_named, ways[i]), span(all_picked, ways[i])
    print "\n| picture | what it shows | named: restricted | small | none | said of the small network's lines |\n|---|---|---|---|---|---|"
    for (p = 1; p <= count; p++) {
        at = pictures[p]
        printf "| %s | %s |", at, name[at]
        for (i = 1; i <= 3; i++) printf " %s |", readers[ways[i]] ? named[ways[i], at] + 0 " of " readers[ways[i]] : ""
        printf " %s |\n", said[at]
    }
    printf "\nIn words: readers named %s of %d with the network that ships, and %s without one. %s.\n", span(all_named, "small"), count, span(all_named, "colours"), date
}
