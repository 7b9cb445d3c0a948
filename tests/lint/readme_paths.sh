#!/usr/bin/env bash
# Everything that a README names exists: paths from the root in `code` or indented lines, and links.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

# Reads README.md line by line and prints "file:line path" for each word of code that begins with a
# folder of the root, and for each link target, seen from the README's own folder.
named_paths() {
    awk '
        function words_of(code,    words, n, i) {
            n = split(code, words, /[ \t`"(),;]+/)
            for (i = 1; i <= n; i++)
                if (words[i] ~ /^(\.ci|app|vision|haptics|audio-cues|config|tests)\/[A-Za-z0-9_.\/-]+$/) {
                    sub(/[.:]+$/, "", words[i])
                    print FILENAME ":" FNR, words[i]
                }
        }
        {
            line = $0
            if (line ~ /^    /) words_of(line)
            while (match(line, /`[^`]+`/)) {
                words_of(substr(line, RSTART, RLENGTH))
                line = substr(line, RSTART + RLENGTH)
            }
            line = $0
            while (match(line, /\]\([^)#]+/)) {
                target = substr(line, RSTART + 2, RLENGTH - 2)
                folder = FILENAME
                sub(/[^\/]*$/, "", folder)
                if (target !~ /:\/\//) print FILENAME ":" FNR, folder target
                line = substr(line, RSTART + RLENGTH)
            }
        }' "$@"
}

readmes=()
mapfile -d '' -t readmes < <(find README.md "${folders[@]}" -name README.md -print0 2>/dev/null)
((${#readmes[@]} > 0)) || exit 0
verdict "$(named_paths "${readmes[@]}" | while read -r place path; do
    [[ -e $path ]] || echo "$place: names $path, which is not there"
done)"
