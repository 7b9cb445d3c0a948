#!/usr/bin/env bash
# versions.sh ROOT: changelog and metainfo name the project's version.
set -euo pipefail
cd "$1"
version=$(sed -n 's/^project(touchline VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[[ -n $version ]] || { echo 'CMakeLists.txt: no version' >&2; exit 1; }
newest=$(sed -n '1s/^touchline (\([^)]*\)).*/\1/p' app/package/debian/changelog)
[[ $newest == "$version" ]] || { echo "changelog: its newest entry is $newest, the project is $version" >&2; exit 1; }
released=$(sed -n 's/.*<release version="\([^"]*\)".*/\1/p' app/package/desktop/*.metainfo.xml | head -n 1)
[[ $released == "$version" ]] || { echo "metainfo: its newest release is $released, the project is $version" >&2; exit 1; }
