# shellcheck shell=bash disable=SC2034 # the lints use what is set here
# Sourced by the lints. Goes to the root of the tree to check, the first argument.
set -euo pipefail

lint=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "${1:?usage: LINT ROOT}"

# The top-level folders that may hold sources.
folders=()
for folder in config vision haptics audio-cues app tests; do
    [[ ! -d $folder ]] || folders+=("$folder")
done

# cpp_sources: every C++ file, ended by NUL, in a fixed order.
cpp_sources() { find "${folders[@]}" -type f \( -name '*.h' -o -name '*.cpp' \) -print0 | LC_ALL=C sort -z; }

# texts: every file that people write, ended by NUL: all but pictures, networks, data, fuzzers'
# finds and catalogues of words.
texts() {
    find "${folders[@]}" .ci -type f ! -path 'tests/data/*' ! -path 'tests/fuzz/corpus/*' \
        ! -name '*.svg' ! -name '*.png' ! -name '*.csv' ! -name '*.json' ! -name '*.po' ! -name '*.pot' ! -name '*.onnx' -print0 2>/dev/null
    find . -maxdepth 1 -type f ! -name LICENSE ! -name compile_commands.json ! -name .git -printf '%P\0'
}

# verdict LINES: prints them and fails if there are any.
verdict() {
    [[ -n $1 ]] || exit 0
    printf '%s\n' "$1"
    exit 1
}
