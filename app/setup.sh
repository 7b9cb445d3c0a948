# Set-up that app/start and tests/run share: install what is missing, configure, build.
# Sourced, never run. Sets `root`, the clone. Whatever fails ends the caller with one line on stderr.

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")

say() { printf 'touchline: %s\n' "$*" >&2; }

stop() {
    say "$*"
    exit 1
}

mkdir -p "$root/build" 2>/dev/null || stop "cannot write in $root"

# missing_packages LIST...: names in config/packages/LIST.txt that dpkg does not have installed.
missing_packages() {
    local list wanted
    wanted=$(for list; do sed 's/#.*//' "$root/config/packages/$list.txt"; done |
        tr -s '[:space:]' '\n' | sed '/^$/d' | LC_ALL=C sort -u)
    # shellcheck disable=SC2086 # one name a word
    LC_ALL=C comm -23 <(printf '%s\n' "$wanted") \
        <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
            sed -n 's/^installed //p' | LC_ALL=C sort -u)
}

# why_apt_failed LOG: the cause in words, from what apt printed.
why_apt_failed() {
    case $(<"$1") in
        *'Could not get lock'* | *'Unable to lock'* | *'Unable to acquire the dpkg'*)
            echo 'another program is installing packages: wait until it is done, then start again' ;;
        *'dpkg was interrupted'*)
            echo "an earlier installation was cut short: run 'dpkg --configure -a' as root, then start again" ;;
        *'No space left on device'* | *'enough free space'*)
            echo 'the disk is full: free about 2 GB, then start again' ;;
        *'Failed to fetch'* | *'Temporary failure resolving'* | *'Unable to connect'*)
            echo 'the package server cannot be reached: check the network, then start again' ;;
        *'Unable to locate package'* | *'no installation candidate'*)
            echo "apt does not know a package: check that apt's sources name Debian 12 main" ;;
        *)
            echo "apt-get says: $(grep -m1 '^E: ' "$1" || tail -n 1 "$1")" ;;
    esac
}

# install_packages LIST...: asks dpkg first; apt and sudo come in only where something is missing.
install_packages() {
    command -v dpkg-query >/dev/null || stop 'there is no dpkg here: Touchline builds on Debian 12'
    local missing system log=$root/build/packages.log as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]} > 0)) || return 0

    system=$(. /etc/os-release && echo "${ID:-unknown} ${VERSION_ID:-}")
    [[ $system == 'debian 12' ]] ||
        stop "this is $system, not Debian 12: install these by hand, then start again: ${missing[*]}"
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            stop "packages are missing and there is no sudo; as root: apt-get install ${missing[*]}"
        say 'packages are missing: sudo may ask for your password'
        sudo true || stop "sudo was refused; as root: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi

    say "installing what is missing (${#missing[@]} packages); this may take some minutes"
    local apt=("${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive
        apt-get -q -y -o DPkg::Lock::Timeout=120)
    # An update that fails need not matter: a foreign source may be down. The installation decides.
    "${apt[@]}" update >"$log" 2>&1 </dev/null || true
    "${apt[@]}" install --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null ||
        stop "$(why_apt_failed "$log") (all of it: $log)"
}

# is_configured PRESET: CMake has finished there, and for this clone: it refuses the cache of a moved one.
is_configured() {
    [[ -e $root/build/$1/build.ninja ]] &&
        grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/$1/CMakeCache.txt"
}

# build PRESET TARGET [OPTION...]: configures with the options, builds; with CI set, warnings are errors.
build() {
    local preset=$1 target=$2 options=("-DTOUCHLINE_WERROR=OFF" "${@:3}")
    [[ ${CI:-false} == false ]] || options+=("-DTOUCHLINE_WERROR=ON")
    is_configured "$preset" || options+=(--fresh)
    if command -v ccache >/dev/null; then
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
    (cd "$root" && cmake --preset "$preset" "${options[@]}" >/dev/null) || stop_build configuring
    (cd "$root" && cmake --build --preset "$preset" --target "$target") || stop_build building
}

stop_build() {
    local free_kB
    free_kB=$(df -Pk "$root/build" | awk 'NR == 2 { print $4 }')
    ((free_kB > 100000)) || stop "$1 failed: the disk is full; free about 2 GB, then start again"
    stop "$1 failed: the lines above say why"
}
