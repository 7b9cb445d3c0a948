#!/usr/bin/env bash
# man_options.sh PROGRAM PAGE.md: the man page has every command and option that --help lists, at
# its command. In any language: the headings of commands are their own names, and the options of the
# program are the fourth section.
set -euo pipefail
program=$1 page=$2

# section NAME: the lines of the page from its heading to the next.
section() { awk -v heading="$1" '/^##/ { inside = ($0 == heading) } inside' "$page"; }

# options COMMAND...: --help and the short ones, as CLI11 writes them at the beginning of a line.
options() { "$program" "$@" --help | grep -oE '^  (-[a-z]|--[a-z0-9-]+)(,--[a-z0-9-]+)?' | tr -d ' ' | tr ',' '\n'; }

# commands COMMAND...: what can follow.
commands() { "$program" "$@" --help | awk '/^Subcommands:/ { inside = 1; next } inside && NF { print $1 }'; }

missing=()
expect() { # HEADING WORDS...: options of these words under that heading
    local heading=$1 option text
    shift
    text=$(section "$heading")
    for option in $(options "$@"); do
        [[ $option == -h || $option == --help || $text == *"**$option**"* ]] || missing+=("${*:-touchline} $option")
    done
}

expect "$(grep '^## ' "$page" | sed -n 4p)"
count=0
for command in $(commands); do
    expect "### $command" "$command"
    text=$(section "### $command")
    [[ -n $text ]] || missing+=("$command")
    for under in $(commands "$command"); do
        expect "### $command" "$command" "$under"
        [[ $text == *"$under"* ]] || missing+=("$command $under")
        count=$((count + 1))
    done
    count=$((count + 1))
done

((count > 10)) || { echo "only $count commands were found: --help is not understood" >&2; exit 1; }
((${#missing[@]} == 0)) || { printf 'not in the man page: %s\n' "${missing[@]}" >&2; exit 1; }
echo "$count commands"
