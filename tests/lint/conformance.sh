#!/usr/bin/env bash
# Every must-have of the checklist has a test that carries its id, and a row in the page of app.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

kept_at_the_site=IN-10

ids() { sed -n 's/^\([A-Z][A-Z]-[0-9]*\) | .*/\1/p' tests/app/conformance/requirements.txt; }

tested=$(grep -rhoE ', (SP|VO|IN|VI|TI|ER|LA|HA)[0-9]+_' tests --include='*.cpp' | sed 's/^, //; s/_$//' | sort -u)
missing=$(ids | while read -r id; do
    [[ $id == "$kept_at_the_site" ]] || grep -qx "${id/-/}" <<<"$tested" ||
        echo "tests: no test has ${id/-/}_ in its name; requirement $id is kept by none"
    grep -q "^| $id |" app/README.md || echo "app/README.md: no row for $id; run tests/app/conformance/run"
done)
[[ -z $missing ]] || { echo "$missing" && exit 1; }
