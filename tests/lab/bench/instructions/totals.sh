#!/usr/bin/env bash
# totals.sh PROGRAM: prints the mean instructions of a servo step, "auto 512 898.8" a row, as in
# recorded.txt; or those of a picture, "drawing 1MP 898.0" a row, as in recorded_map.txt.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/callgrind.sh"

dumps=$(mktemp)
trap 'rm -f "$dumps"' EXIT
count_steps "$dumps" "${1:?usage: totals.sh PROGRAM}" total
sums_of "$dumps" | awk '{ printf "%s %s %.1f\n", $1, $2, $4 / $3 }'
