#!/usr/bin/env bash
# gate.sh PROGRAM [RECORDED]: fails if a step takes over 5 % more instructions than recorded.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
. "$here/callgrind.sh"
counted=$(totals_of "${1:?usage: gate.sh PROGRAM [RECORDED]}")
awk -f "$here/gate.awk" "${2:-$here/recorded.txt}" - <<<"$counted"
