# A page with one tag a line can be read from top to bottom: language named, one title, headings in order, no tables, nothing
# placed beside the text, a text for each picture.
function wrong(what) { print page ": " what > "/dev/stderr"; bad = 1 }
/^<html/ { has_language = /lang="[a-z]+/ }
/^<title>./ { titles++ }
/^<h[1-6]/ {
    level = substr($0, 3, 1)
    if (level == 1) tops++
    if (level > last + 1) wrong("heading of level " level " after one of level " last ": " $0)
    if ($0 ~ /^<h[1-6][^>]*>$/) wrong("an empty heading")
    last = level
    headings++
}
/^<(table|frame|iframe|script|aside|marquee|font|center)[ >]/ { wrong("not linear: " $0) }
/^<img/ && !/alt="[^"]+"/ { wrong("a picture without words: " $0) }
/(float|position|columns|display) *:/ { wrong("placed beside the text: " $0) }
/^<a / && />(here|link|this)?$/ { wrong("a link that does not say where to: " $0) }
END {
    if (!has_language) wrong("no language")
    if (titles != 1) wrong("not one title")
    if (tops != 1) wrong("not one heading of level 1")
    if (headings < 5) wrong("hardly a heading to go by")
    exit bad
}
