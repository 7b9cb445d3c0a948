#!/usr/bin/env bash
# The gate finds what it looks for.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
faults=0

# expect STATUS TEXT COUNTED: checks the gate's status and text against two recorded rows.
expect() {
    local said status=0
    said=$(awk -f "$here/gate.awk" <(printf '# words\nauto 512 1000.0\n0 512 2000.0\n') - <<<"$3") || status=$?
    [[ $status == "$1" && $said == *"$2"* ]] && return
    printf 'expected %s and "%s", got %s and:\n%s\n' "$1" "$2" "$status" "$said"
    faults=1
}

expect 0 'as recorded' $'auto 512 1049.0\n0 512 1901.0'
expect 1 'too many' $'auto 512 1051.0\n0 512 2000.0'
expect 1 'too many' $'auto 512 900.0\n0 512 2101.0'
expect 0 'record the new figures with' $'auto 512 949.0\n0 512 2000.0'
expect 1 'nothing is recorded' $'auto 512 1000.0\n0 512 2000.0\n0 4096 1.0'
expect 1 'not counted' $'auto 512 1000.0'
expect 1 'not counted' ''
exit $faults
