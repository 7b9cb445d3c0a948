#!/usr/bin/env bash
# The lints find what they look for, in small trees, good and bad, in a folder of their own.
# lint_test.sh ROOT [without_format]
set -euo pipefail
lint=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

# start_tree: an empty project that every lint accepts.
start_tree() {
    rm -rf "${tree:?}"/*
    mkdir -p "$tree"/{config/types,vision/contour,haptics/{curve,contact,servo},app/{screen,documents/decode},tests/vision}
    local folder
    for folder in . config config/types vision vision/contour haptics haptics/{curve,contact,servo} \
        app app/screen app/documents app/documents/decode tests; do
        echo 'What it is.' >"$tree/$folder/README.md"
    done
    write config/types/vec2.h '#pragma once' '#include <cmath>'
    write haptics/curve/curve.h '#include "config/types/vec2.h"'
    write haptics/contact/contact.h '#include "haptics/curve/curve.h"'
    write vision/contour/edges.cpp '#include <opencv2/imgproc.hpp>'
    write app/screen/window.cpp '#include "haptics/contact/contact.h"' '#include <GLFW/glfw3.h>'
}

# write FILE LINE...
write() { printf '%s\n' "${@:2}" >"$tree/$1"; }

complain() {
    printf 'lint_test.sh:%s: %s\n' "${BASH_LINENO[1]}" "$1"
    failed=1
}

passes() {
    local said
    said=$(bash "$lint/$1.sh" "$tree" 2>&1) || complain "$1 should pass, but says: $said"
}

# finds LINT TEXT: the lint fails and says TEXT, file and line first.
finds() {
    local said
    if said=$(bash "$lint/$1.sh" "$tree" 2>&1); then
        complain "$1 should fail with: $2"
    elif [[ $'\n'$said != *$'\n'"$2"* ]]; then
        complain "$1 should say: $2 - but says: $said"
    fi
}

# bad_include FILE HEADER TEXT: the lint finds the header, included on line 2 of the file.
bad_include() {
    start_tree
    write "$1" '// Line one.' "#include $2"
    finds includes "$1:2: includes ${2:1:-1}: $3"
}

start_tree
for name in includes types text layout readme_paths charts; do passes "$name"; done

start_tree
write haptics/curve/curve.h 'namespace touchline {' 'struct Segment {' '};' '}  // namespace touchline'
write vision/contour/grid.h 'namespace touchline {' 'struct Grid;' 'struct Segment {' '};' '}  // namespace touchline'
finds types 'vision/contour/grid.h:3: touchline::Segment is defined in haptics/curve/curve.h too'
write vision/contour/grid.h 'namespace touchline {' 'namespace {' 'struct Segment {' '};' '}  // namespace' '}  // namespace touchline'
passes types

bad_include config/types/vec2.h '"haptics/curve/curve.h"' 'config may include only: itself'
bad_include vision/contour/edges.h '"haptics/curve/curve.h"' 'vision may include only: config'
bad_include haptics/curve/curve.h '"vision/contour/edges.h"' 'no such file'
bad_include haptics/curve/line.cpp '"haptics/contact/contact.h"' 'haptics/curve may include only: config'
bad_include haptics/curve/line.cpp '"curve.h"' 'no such file; include by path from the root'
bad_include haptics/contact/contact.cpp '<opencv2/core.hpp>' 'allowed in: vision app tests'
bad_include haptics/servo/loop.cpp '<GL/gl.h>' 'allowed in: app/screen'
bad_include haptics/servo/loop.cpp '<samplerate.h>' 'allowed in: audio-cues/speech'
bad_include haptics/servo/loop.cpp '<libusb-1.0/libusb.h>' 'allowed in: haptics/device/board'
bad_include vision/contour/edges.cpp '<opencv2/imgcodecs.hpp>' 'allowed in: nobody'
bad_include tests/vision/edges_test.cpp '<opencv2/highgui.hpp>' 'allowed in: nobody'
bad_include vision/contour/edges.cpp '<opencv2/opencv.hpp>' 'allowed in: nobody'
bad_include vision/contour/edges.cpp '<png.h>' 'allowed in: app/documents/decode'
bad_include app/screen/window.cpp '<pugixml.hpp>' 'allowed in: app/documents/decode'
bad_include app/documents/decode/svg.cpp '<GLFW/glfw3.h>' 'allowed in: app/screen'
bad_include app/documents/decode/svg.cpp '<gtest/gtest.h>' 'allowed in: tests'
bad_include app/documents/decode/svg.cpp '<nowhere/any.hpp>' 'no rule names this library'
start_tree
write haptics/curve/curve.cpp '#include "config/types/vec2.h"' '#include "haptics/curve/curve.h"'
finds includes 'haptics/curve/curve.cpp:1: includes config/types/vec2.h: its own header comes first: haptics/curve/curve.h'
start_tree
write haptics/spare.h '#  include  "config/types/vec2.h"'
finds includes 'haptics/spare.h:1: includes config/types/vec2.h: no rule names the folder'

if [[ ${2-} != without_format ]]; then
    start_tree
    passes format
    write haptics/curve/curve.cpp 'int x;' 'int  f( );'
    finds format 'haptics/curve/curve.cpp:2: '
fi
mkdir -p "$tree/.bin"
ln -sf "$(command -v bash)" "$(command -v dirname)" "$tree/.bin"
PATH=$tree/.bin finds format 'clang-format-14 is not installed'

# The words are put together here, so that this file may itself be in the checked tree.
bad_text() {
    start_tree
    write app/screen/window.cpp 'int x;' "$1"
    finds text "app/screen/window.cpp:2:$1    <- $2"
}
bad_text "// TO""DO: more" 'finish it'
bad_text "// a HA""CK" 'finish it'
bad_text "GTEST_""SKIP();" 'no test is skipped'
bad_text "TEST(Curve, DISABLED""_Slow) {}" 'no test is skipped'
bad_text 'open("/wor''k/x");' 'a path of one machine'
bad_text 'int y; ' 'blanks at the end'
bad_text 'err << error.line;' 'printed as it came'
start_tree
write app/screen/window.cpp 'constexpr double kStep_mm = 0.5;'
finds text 'app/screen/window.cpp:1:kStep_mm    <- a constant is written like all other names'
write app/screen/window.cpp '// At 4 kHz, of 8 kB, from kT + t_d on.'
passes text
start_tree
write app/screen/window.cpp 'mkstemp("mapXXXXXX");' 'auto home = "http/work/";'
passes text
seq 600 >"$tree/app/screen/window.cpp"
passes text
seq 601 >"$tree/app/screen/window.cpp"
finds text 'app/screen/window.cpp:601: longer than 600 lines'
start_tree
seq 151 >"$tree/haptics/README.md"
finds text 'haptics/README.md:151: a README has at most 150 lines'

start_tree
mkdir "$tree/tools"
finds layout 'tools: not one of the entries'
start_tree
rm "$tree/haptics/curve/README.md"
finds layout 'haptics/curve: has no README.md'
start_tree
rm "$tree/README.md"
finds layout '.: has no README.md'

start_tree
write README.md 'Start it:' '' '    app/start --window'
finds readme_paths 'README.md:3: names app/start'
write README.md 'See `app/screen/window.cpp`, [curve](haptics/curve/curve.h), `tests/*_test.cpp`.'
passes readme_paths
write haptics/README.md 'See [the curve](curve/curve.h), [more](curve/none.h) and `haptics/none.h`.'
finds readme_paths 'haptics/README.md:1: names haptics/none.h'
finds readme_paths 'haptics/README.md:1: names haptics/curve/none.h'

start_tree
chart='![Error against time, a line for each of the methods.](results/error.svg)'
write tests/README.md '## Error' '' "$chart" '' '| a | b |' '' 'The first is best. The second is not.'
passes charts
write tests/README.md '## Error' '' "$chart" '' 'The first is best. The second is not.' '## Else' '| a | b |'
finds charts 'tests/README.md: results/error.svg: no table in its section'
write tests/README.md '## Error' '' "$chart" '' '| a | b |' '' 'The first is best.'
finds charts 'tests/README.md: results/error.svg: not two sentences in its section'
write tests/README.md '![Error](results/error.svg)' '| a | b |' 'The first is best. The second is not.'
finds charts 'tests/README.md: results/error.svg: its alternative text says too little'

exit "$failed"
