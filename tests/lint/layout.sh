#!/usr/bin/env bash
# The top level holds what the architecture names; every folder with sources explains itself.
. "$(dirname "${BASH_SOURCE[0]}")/sources.sh"

strangers() {
    local name
    for name in *; do
        case $name in
            CMakeLists.txt | app | vision | haptics | audio-cues | config | tests | README.md) ;;
            CMakePresets.json | LICENSE) ;;
            build | compile_commands.json) ;; # made by building, ignored by git
            *) echo "$name: not one of the entries of the top level" ;;
        esac
    done
}

# The top folders, their sub-folders, and those sub-folders of tests that mirror no other folder.
without_readme() {
    local folder
    for folder in . "${folders[@]}" {config,vision,haptics,audio-cues,app}/*/ \
        tests/{lab,machines}{,/*}/ tests/{fuzz,data,lint}; do
        folder=${folder%/}
        [[ -f $folder/README.md || -z $(find "$folder" -type f ! -name CMakeLists.txt -print -quit 2>/dev/null) ]] ||
            echo "$folder: has no README.md"
    done
}

verdict "$(
    strangers
    without_readme
)"
