# The set-up that app/start and tests/run share: installs what is missing, configures, builds.
# Sourced, never run. Sets `root`, the clone. Any failure ends the caller with one line on stderr.

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")

say() { printf 'touchline: %s\n' "$*" >&2; }

stop() {
    say "$*"
    exit 1
}

mkdir -p "$root/build" 2>/dev/null || stop "cannot write in $root"

# The system, as in "debian 12", and the Debian that it is or derives from, as in "12.5" or
# "trixie/sid".
os_name=$(. /etc/os-release 2>/dev/null && echo "${ID:-unknown} ${VERSION_ID:-}" || echo unknown)
os_origin=$(cat /etc/debian_version 2>/dev/null || echo unknown)

# is_tried NAME: whether that is one of the systems that we test. Raspberry Pi OS calls itself
# debian or raspbian.
is_tried() { [[ $1 =~ ^(debian|raspbian)\ (12|13)$ ]]; }

# release_of ORIGIN: the Debian, 12 or 13, whose package names hold there; the nearest for any
# other.
release_of() {
    case $1 in
        1[0-2] | 1[0-2].* | bookworm*) echo 12 ;;
        *) echo 13 ;;
    esac
}

# suite_of RELEASE: what Debian's archive calls it.
suite_of() {
    case $1 in
        12) echo bookworm ;;
        13) echo trixie ;;
        *) stop "there is no Debian $1 here: 12 or 13" ;;
    esac
}

# packages LIST...: the names in config/packages/LIST.txt that hold here, one a line. Leaves out
# NAME? if a command of that name exists: npm also comes with packages of other archives, which
# conflict with Debian's.
packages() {
    local list name
    for list; do sed 's/#.*//' "$root/config/packages/$list.txt"; done | tr -s '[:space:]' '\n' |
        awk -F@ -v release="$(release_of "$os_origin")" '$1 && (NF == 1 || $2 == release) { print $1 }' | LC_ALL=C sort -u |
        while read -r name; do
            [[ $name == *\? ]] && command -v "${name%\?}" >/dev/null || printf '%s\n' "${name%\?}"
        done
}

# missing_packages LIST...: those of the names that dpkg has not installed.
missing_packages() {
    local wanted
    wanted=$(packages "$@")
    # shellcheck disable=SC2086 # one name a word
    LC_ALL=C comm -23 <(printf '%s\n' "$wanted") \
        <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
            sed -n 's/^installed //p' | LC_ALL=C sort -u)
}

# why_apt_failed LOG: the cause in words, from apt's output.
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
            echo "apt does not know a package: check that apt's sources name all of Debian's main" ;;
        *)
            echo "apt-get says: $(grep -m1 '^E: ' "$1" || tail -n 1 "$1")" ;;
    esac
}

# install_packages LIST...: asks dpkg first; uses apt and sudo only if something is missing.
install_packages() {
    command -v dpkg-query >/dev/null || stop "this is $os_name, without dpkg: Touchline builds on Debian 12 and 13"
    local missing log=$root/build/packages.log as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]} > 0)) || return 0

    is_tried "$os_name" ||
        say "this is $os_name, where Touchline was never tried: it takes the packages of Debian $(release_of "$os_origin"), the nearest"
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
    # A failed update may not matter, because a foreign source may be down. The installation
    # decides.
    "${apt[@]}" update >"$log" 2>&1 </dev/null || true
    "${apt[@]}" install --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null ||
        stop "$(why_apt_failed "$log") (all of it: $log)"
}

# is_configured PRESET: whether CMake has finished there, for this clone: it refuses the cache of a
# moved one.
is_configured() {
    [[ -e $root/build/$1/build.ninja ]] &&
        grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/$1/CMakeCache.txt"
}

# build PRESET TARGET [OPTION...]: configures with the options and builds; with CI set, warnings are
# errors.
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
