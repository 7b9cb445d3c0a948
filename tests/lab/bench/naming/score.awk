# Which answers are right, as a table: pictures.csv, order.csv and the answers in. What was said is right where a word of the
# name or of what is also right stands in it by itself.
function has(text, word) { return word != "" && (" " text " ") ~ (" " word "s?(es)? ") }
function plain(text) { text = tolower(text); gsub(/[^a-z ]+/, " ", text); return text }
BEGIN {
    print "| picture | what it shows | said of its lines | | picked from the list | |"
    print "|---|---|---|---|---|---|"
}
FNR == 1 { part++ }
part == 1 && FNR > 1 { name[$1] = $3; right[$1] = $3 "|" $4 }
part == 2 { file[$1 + 0] = $2 }
part == 3 && $1 + 0 > 0 {
    at = file[$1 + 0]
    is_named = 0
    count = split(right[at], words, "|")
    for (i = 1; i <= count; i++) if (has(plain($2), plain(words[i]))) is_named = 1
    is_found = $3 == name[at]
    answers++
    named += is_named
    found += is_found
    printf "| %s | %s | %s | %s | %s | %s |\n", at, name[at], $2, is_named ? "right" : "wrong", $3, is_found ? "right" : "wrong"
}
END { printf "\nIn words: a reader named %d of %d, and picked %d from the list of all names. %s.\n", named, answers, found, date }
