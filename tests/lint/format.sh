#!/usr/bin/env bash
# Every C++ file looks as clang-format 14 leaves it.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

command -v clang-format-14 >/dev/null || verdict 'clang-format-14 is not installed (tests/run installs it)'
verdict "$(cpp_sources | xargs -0 -r clang-format-14 --dry-run 2>&1 |
    awk -F: '/warning:/ && !seen[$1]++ { print $1 ":" $2 ": run clang-format-14 -i" } /^error|No such/ { print }')"
