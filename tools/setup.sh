#!/usr/bin/env bash
# Installs the packages of tools/packages.txt that are missing. With all of them there it does not touch the package
# manager. Needs to be root, or sudo.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "setup: no dpkg and apt-get here; install the counterparts of tools/packages.txt by hand" >&2
    exit 1
fi

mapfile -t wanted < <(sed 's/#.*//' packages.txt | awk 'NF { print $1 }')

is_installed() {
    local status
    status=$(dpkg-query -W -f '${db:Status-Status} ' "$1" 2>/dev/null || true)
    [[ " $status" == *" installed "* ]]
}
# True as well while there are no package lists that could tell.
may_be_offered() { ! compgen -G "/var/lib/apt/lists/*_Packages*" >/dev/null || apt-cache show "$1" >/dev/null 2>&1; }

# What is not there and can be had.
find_missing() {
    local entry package
    missing=()
    for entry in "${wanted[@]}"; do
        package=${entry%\?}
        is_installed "$package" && continue
        [[ $entry == *\? ]] && ! may_be_offered "$package" && continue
        missing+=("$package")
    done
}
find_missing
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        echo "setup: missing packages, and neither root nor sudo to install them: ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

apt_get() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"
}

echo "setup: installing ${missing[*]}"
apt_get update || echo "setup: the package lists could not all be refreshed; going on with those there are" >&2
find_missing
apt_get install -y --no-install-recommends "${missing[@]}"
