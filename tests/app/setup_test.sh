#!/usr/bin/env bash
# setup_test.sh ROOT: the packages are those of the release; an unknown system takes the nearest,
# and counts as untried.
set -euo pipefail
. "$1/app/setup.sh"
failed=0
equal() { # WHAT IS WANTED
    [[ $2 == "$3" ]] || { echo "$1: '$2', not '$3'" && failed=1; }
}

for one in 12 12.11 bookworm/sid 11.7; do equal "names for $one" "$(release_of "$one")" 12; done
for one in 13 13.2 trixie/sid forky/sid unknown; do equal "names for $one" "$(release_of "$one")" 13; done

for one in 'debian 12' 'debian 13' 'raspbian 13'; do equal "$one is tried" "$(is_tried "$one" && echo yes)" yes; done
for one in 'ubuntu 24.04' 'debian 11' 'debian ' 'debian 120' 'fedora 13' unknown; do
    equal "$one is not tried" "$(is_tried "$one" || echo no)" no
done

os_origin=12.11
equal 'other compiler on 12' "$(packages clang)" clang-16
equal 'formatter on 12' "$(packages test | grep clang)" clang-format-14
build_12=$(packages build)
os_origin=13.1
equal 'other compiler on 13' "$(packages clang)" clang-19
equal 'formatter on 13' "$(packages test | grep clang || true)" ''
equal 'building on 13 as on 12' "$(packages build)" "$build_12"
equal 'names without a mark of the release' "$(packages build run test package | grep '[@#]' || true)" ''
equal 'names, each once' "$(packages build build)" "$build_12"
exit $failed
