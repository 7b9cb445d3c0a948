#!/usr/bin/env bash
# Every test that a hazard names exists: as a case of GoogleTest or RapidCheck, or as a CMake test.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

page=tests/lab/reliability/hazards.tsv
[[ -e $page ]] || exit 0

cases() {
    find tests -name '*.cpp' -print0 | xargs -0 cat | tr '\n' ' ' |
        grep -oE '\<(TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\( *[A-Za-z0-9_]+, *[A-Za-z0-9_]+' |
        sed -E 's/.*\( *//; s/, */./'
    find tests -name CMakeLists.txt -print0 | xargs -0 sed -nE 's/.*add_test\(NAME ([A-Za-z0-9_.]+).*/\1/p'
}

named() {
    awk -F'\t' '!/^#/ { n = split($4, words, " "); for (i = 1; i <= n; i++) if (words[i] ~ /^[A-Z][A-Za-z0-9]*[.][A-Z]/) print words[i] }' "$page"
}

verdict "$(LC_ALL=C comm -23 <(named | LC_ALL=C sort -u) <(cases | LC_ALL=C sort -u) | sed "s|^|$page: names a test that is not there: |")"
