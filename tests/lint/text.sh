#!/usr/bin/env bash
# What no text of the project may hold, and how long a file may be.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

# find_text WHY GREP_OPTION PATTERN: file:line of each match. The patterns are spelt so that they do not match themselves.
find_text() {
    { texts | xargs -0 -r grep -HnI "$2" "$3" || true; } | sed "s|\$|    <- $1|"
}

verdict "$(
    find_text 'finish it, or say it in the commit' -wE 'TOD[O]|FIXM[E]|XX[X]|HAC[K]'
    find_text 'no test is skipped' -E 'GTEST_SKI[P]|DISABLE[D]_'
    find_text 'a path of one machine' -E '(^|[^A-Za-z0-9_.])/(work|root|farm|home|tmp)/'
    find_text 'blanks at the end of the line' -E '[[:blank:]]+$'
    find_text 'printed as it came: a name in it may command the terminal' -E \
        '(err <<|stder[r]).*(error\(\)\.line|error\.line|what\(\))' | grep '^app/' | grep -v 'plain_lin[e](' || true
    cpp_sources | { xargs -0 -r grep -HnowE 'k[A-Z][A-Za-z0-9_]*' || true; } | grep -vE ':k(Hz|B|T)$' |
        sed 's|$|    <- a constant is written like all other names|' || true
    texts | xargs -0 -r awk '
        FNR == 601 { print FILENAME ":601: longer than 600 lines" }
        FNR == 151 && FILENAME ~ /(^|\/)README\.md$/ { print FILENAME ":151: a README has at most 150 lines" }'
)"
