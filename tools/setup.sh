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

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query -W -f '${db:Status-Status} ' "$package" 2>/dev/null || true)
    [[ " $status" == *" installed "* ]] || missing+=("$package")
done
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
apt_get install -y --no-install-recommends "${missing[@]}"
