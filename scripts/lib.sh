# shellcheck shell=bash
# Shared by the scripts beside it, which source it after `set -euo pipefail`. Everything is said on standard error, so
# that standard output belongs to the program that is run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# fail STATUS TEXT...
fail() {
    local status=$1
    shift
    say "$@"
    exit "$status"
}

# The names in a package list, a line each.
packages_in() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$1"; }

# Those of the packages given that are not installed, a line each.
missing_packages() {
    local installed name
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for name in "$@"; do
        grep -qxF "installed $name" <<<"$installed" || printf '%s\n' "$name"
    done
}

# Runs apt-get as root, directly or through sudo where this is another user; what it says is shown where it fails.
apt_get() {
    local as_root=() log
    ((EUID == 0)) || as_root=(sudo)
    log=$(mktemp)
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q -o DPkg::Lock::Timeout=300 "$@" \
        </dev/null >"$log"; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

# Whether apt knows a version of every package given.
apt_knows() {
    local name
    for name in "$@"; do
        grep -q '^Version:' < <(apt-cache show "$name" 2>/dev/null) || return 1
    done
}

# need LIST...: installs what is missing of the package lists (files in this folder).
need() {
    local wanted=() missing=() list
    for list in "$@"; do
        mapfile -t -O "${#wanted[@]}" wanted < <(packages_in "$root/scripts/$list")
    done
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        say "no apt here: going on with what is installed; these are needed (Debian's names): ${wanted[*]}"
        return
    fi
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    ((${#missing[@]})) || return 0
    ((EUID == 0)) || command -v sudo >/dev/null ||
        fail 1 "packages are missing, and without sudo only root can install them: apt-get install ${missing[*]}"
    say "installing ${#missing[@]} packages (this may take some minutes): ${missing[*]}"
    # Old lists name files that mirrors no longer have, so a failed installation is tried once more with new ones.
    if ! { apt_knows "${missing[@]}" && apt_get install --no-install-recommends "${missing[@]}"; }; then
        apt_get update || fail 1 "apt-get update failed"
        apt_get install --no-install-recommends "${missing[@]}" || fail 1 "apt-get could not install: ${missing[*]}"
    fi
}

# Compilers at a time: one a processor, and at least a gigabyte of free memory for each.
parallel_jobs() {
    local processors gigabytes
    processors=$(nproc)
    gigabytes=$(awk '/^MemAvailable:/ {print int($2 / 1048576)}' /proc/meminfo 2>/dev/null || true)
    ((${gigabytes:-$processors} < processors)) && processors=$gigabytes
    printf '%s\n' "$((processors > 1 ? processors : 1))"
}

must_be_writable() {
    [[ -w $1 ]] || fail 4 "cannot write to $1: does it belong to another user (made through sudo)?"
}

# configure PRESET: once; afterwards the build itself notices changed CMake files.
configure() {
    local preset=$1 build=$root/build/$1 log
    [[ -e $build/build.ninja ]] && return
    mkdir -p "$build" 2>/dev/null || true
    must_be_writable "$build"
    log=$build/configure.log
    say "configuring $build"
    cmake -S "$root" --preset "$preset" >"$log" 2>&1 || {
        cat "$log" >&2
        fail 1 "configuring failed; this was $log"
    }
}

# build PRESET [TARGET...]: quiet where there is nothing to do.
build() {
    local build=$root/build/$1
    shift
    [[ $(ninja -C "$build" -n "$@" 2>/dev/null | tail -n 1) == 'ninja: no work to do.' ]] && return
    must_be_writable "$build"
    say "building (the first time takes some minutes)"
    ninja -C "$build" -j "$(parallel_jobs)" "$@" >&2 || fail 1 "the build failed"
}
