# shellcheck shell=bash
# Sourced. Counts with callgrind inside the servo step, and inside the way from a picture to its
# lines.

# count_steps DUMPS PROGRAM [PART...] [-- OPTION...]: writes the program's dumps into one new file.
count_steps() {
    local dumps=$1 words=() log
    shift
    while (($# > 0)) && [[ $1 != -- ]]; do words+=("$1") && shift; done
    [[ ${1-} != -- ]] || shift
    log=$(mktemp)
    rm -f "$dumps"
    # A profile of the whole run would also hold lines and calls; only the sums of each dump are
    # read.
    valgrind --tool=callgrind --instr-atstart=no --toggle-collect=touchline_servo_step \
        --toggle-collect=touchline_picture_map \
        --combine-dumps=yes --dump-line=no --dump-instr=no --callgrind-out-file="$dumps" "$@" \
        "${words[@]}" >"$log" 2>&1 || {
        cat "$log" >&2
        rm -f "$log"
        return 1
    }
    rm -f "$log"
}

# totals_of PROGRAM: prints the mean instructions of a servo step, "auto 512 898.8" a row, as in
# recorded.txt; or those of a picture, "drawing 1MP 898.0" a row, as in recorded_map.txt.
totals_of() {
    local dumps status=0
    dumps=$(mktemp)
    # Of its own, because `set -e` does not hold in a command substitution.
    { count_steps "$dumps" "$1" total && sums_of "$dumps" | awk '{ printf "%s %s %.1f\n", $1, $2, $4 / $3 }'; } || status=$?
    rm -f "$dumps"
    return "$status"
}

# sums_of DUMPS: a line for each named dump, its name and its sums: "auto 512 2000 413".
sums_of() {
    awk '
        /^desc: Trigger: / { name = sub(/^desc: Trigger: Client Request: /, "") ? $0 : "" }
        /^totals: / && name != "" { sub(/^totals: /, ""); print name, $0; name = "" }' "$1"
}
