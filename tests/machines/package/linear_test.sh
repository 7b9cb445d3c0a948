#!/usr/bin/env bash
# linear_test.sh LINEAR.awk: the judge of the pages lets a good one pass and finds each fault, one
# at a time.
set -euo pipefail
judge=$1

page() { # a good page, changed by a sed script
    printf '%s\n' '<html lang="en">' '<title>Kiosk' '<h1>Kiosk' '<h2>First' '<h3>Part' '<h2>Second' '<h2>Third' \
        '<img src="a.png" alt="a hand at the handle">' '<a href="b.html">the man page' | sed "$1"
}

page '' | awk -v page=good -f "$judge" || { echo 'a good page was refused' >&2; exit 1; }

count=0
while IFS= read -r change; do
    ! page "$change" | awk -v page=bad -f "$judge" 2>/dev/null || { echo "not found: $change" >&2; exit 1; }
    count=$((count + 1))
done <<'CHANGES'
s/ lang="en"//
s/<title>Kiosk/<title>/
/<h1>/d
s/<h2>Second/<h1>Second/
/<h2>First/d
s/<h3>Part/<h5>Part/
s/<h2>Third/<h2>/
s/ alt="[^"]*"//
s/alt="[^"]*"/alt=""/
s/<h3>Part/<table>/
s/<h3>Part/<p style="float: left">/
s/>the man page/>here/
CHANGES
((count == 12))
