#!/usr/bin/env bash
# No two types have the same name.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

verdict "$(cpp_sources | xargs -0 -r awk -f "$lint/types.awk")"
