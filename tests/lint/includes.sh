#!/usr/bin/env bash
# Who includes whom: checks the #include lines of all sources against layers.txt.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

cpp_sources | xargs -0 -r awk -f "$lint/includes.awk" "$lint/layers.txt"
