# The table of settings (config/README.md) as headings and sentences: who listens cannot go along columns.
function trimmed(text) { gsub(/^ +| +$/, "", text); return text }
BEGIN {
    who["site"] = "Only the file of this kiosk sets it."
    who["profile"] = "The file of this kiosk and a profile set it."
    who["session"] = "The file of this kiosk and a profile set it; a visitor may change it for the visit."
}
/^\| `/ {
    split($0, cell, "|")
    key = trimmed(cell[2]); allowed = trimmed(cell[3]); first = trimmed(cell[4]); upto = trimmed(cell[5])
    what = trimmed(cell[6])
    gsub(/`/, "", key)
    group = key; sub(/\..*/, "", group)
    name = what; sub(/:.*/, "", name)
    sentence = what; sub(/^[^:]*: */, "", sentence)
    if (!(upto in who)) { print "settings.awk: what is " upto "?" > "/dev/stderr"; exit 1 }
    if (group != last) printf "### Settings of %s\n\n", group
    last = group
    printf "#### %s\n\n%s\n\n`%s` is %s. At first: %s. %s\n\n", name, sentence, key, allowed, first, who[upto]
    rows++
}
END { if (!rows) { print "settings.awk: no table of settings" > "/dev/stderr"; exit 1 } }
