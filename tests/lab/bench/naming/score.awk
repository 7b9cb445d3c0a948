# Which answers are right: pictures.csv, order.csv and the answers in; file,name,said,named,picked,found out.
# What was said is right where a word of the name or of what is also right stands in it by itself.
function has(text, word) { return word != "" && (" " text " ") ~ (" " word "s?(es)? ") }
function plain(text) { text = tolower(text); gsub(/[^a-z ]+/, " ", text); return text }
FNR == 1 { part++ }
part == 1 && FNR > 1 { name[$1] = $3; right[$1] = $3 "|" $4 }
part == 2 { file[$1 + 0] = $2 }
part == 3 && $1 + 0 > 0 {
    at = file[$1 + 0]
    named = 0
    count = split(right[at], words, "|")
    for (i = 1; i <= count; i++) if (has(plain($2), plain(words[i]))) named = 1
    print at "," name[at] "," $2 "," named "," $3 "," ($3 == name[at] ? 1 : 0)
}
