#!/usr/bin/env bash
# Checks the tactile labels in every language: their dots say what an independent braille translator
# makes of the word, no word or braille is wider than its plate, and a key's label is its name in
# the catalogue.
# Usage: labels.sh LABELS_SCRIPT CATALOGUES
set -euo pipefail
export LC_ALL=C.UTF-8
labels=$1
catalogues=$2
declare -A table=([en]=en-ueb-g1.ctb [de]=de-g0.utb [fr]=fr-bfu-comp6.utb [es]=es-g1.ctb [it]=it-it-comp6.utb)
failures=0
fail() {
    echo "$1"
    failures=$((failures + 1))
}

# cells SVG: a line for each label: its word, then the dots of its cells as bits (dot 1 is 1, dot 6
# is 32).
cells() {
    awk -F'"' '
    /<title>.*: / { word = $0; sub(/.*: /, "", word); sub(/<.*/, "", word) }
    /<rect x=.*rx=/ { left = $2 + 7; top = $4 + 29; last = -1; delete cell }
    /<circle/ {
        x = $2 - left; y = $4 - top; i = int(x / 6); column = (x - 6 * i > 1.25); row = int(y / 2.5 + 0.5)
        cell[i] += 2 ^ (row + 3 * column)
        if (i > last) last = i
        if ($2 + 0.75 > left + 81 - 3) print "too wide: " word > "/dev/stderr"
    }
    /<\/g>/ { printf "%s", word; for (i = 0; i <= last; ++i) printf " %d", cell[i]; print "" }' "$1"
}

# reference WORD TABLE: the same by liblouis.
reference() {
    local pattern i
    pattern=$(printf '%s' "$1" | lou_translate "unicode.dis,$2")
    for ((i = 0; i < ${#pattern}; ++i)); do
        printf ' %d' $(($(printf '%d' "'${pattern:i:1}") - 0x2800))
    done
}

# name_of KEY LANGUAGE: the kiosk's name for the key.
name_of() {
    local name=$1
    [[ $2 == en ]] || name=$(awk -F'"' -v key="$1" '
        /^msgctxt/ { context = $2 }
        /^msgid/ { id = $2 }
        /^msgstr/ && context == "keys" && id == key { print $2 }' "$catalogues/$2.po")
    echo "${name,,}"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for language in "${!table[@]}"; do
    bash "$labels" "$language" >"$work/labels.svg"
    rsvg-convert "$work/labels.svg" -o "$work/labels.png" || fail "$language: not an SVG"
    cells "$work/labels.svg" >"$work/cells.txt" 2>"$work/wide.txt"
    [[ ! -s $work/wide.txt ]] || fail "$language: $(<"$work/wide.txt")"
    (($(wc -l <"$work/cells.txt") == 10)) || fail "$language: not ten labels"
    while read -r word dots; do
        [[ " $dots" == "$(reference "$word" "${table[$language]}")" ]] || fail "$language: $word reads $dots"
    done <"$work/cells.txt"
    while IFS='|' read -r code place word; do
        [[ $code == "$language" && $place == *' key' ]] || continue
        [[ $word == "$(name_of "${place% key}" "$language")" ]] || fail "$language: the $place is labelled $word"
    done <"${labels}.txt"
done
bash "$labels" xx >"$work/none" 2>"$work/error" && fail 'an unknown language is taken'
grep -q "there are: de en es fr it" "$work/error" || fail 'an unknown language is refused without saying which there are'
exit $((failures > 0))
