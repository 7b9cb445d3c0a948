#!/usr/bin/env bash
# Every chart in a README (an image in a folder `results`) has an alternative text and, in its own
# section, a table and at least two sentences, because some of our readers cannot see it.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

verdict "$(find "${folders[@]}" README.md -name 'README.md' -not -path '*/build/*' | sort | while read -r page; do
    awk -v page="$page" '
    function sentences(text,   parts) { return split(text, parts, /[.!?:]([ \n]|$)/) - 1 }
    function judge() {
        if (chart != "") {
            if (!has_table) print page ": " chart ": no table in its section"
            if (alt !~ /[^ ] [^ ]+ [^ ]+ [^ ]+ [^ ]+ [^ ]+/) print page ": " chart ": its alternative text says too little"
            if (sentences(words) < 2) print page ": " chart ": not two sentences in its section"
        }
        chart = ""; alt = ""; words = ""; has_table = 0
    }
    /^#/ { judge() }
    /^\|/ { has_table = 1 }
    /^!\[/ { in_alt = 1; this = "" }
    in_alt {
        this = this $0 "\n"
        if (/\]\([^)]*\)/) {
            in_alt = 0
            where = this; sub(/.*\]\(/, "", where); sub(/\).*/, "", where)
            if (where ~ /(^|\/)results\//) { chart = where; alt = this }
        }
    }
    !in_alt && !/^[#|!<]/ && !/\]\([^)]*\)/ { words = words $0 "\n" }
    END { judge() }' "$page"
done)"
