#!/usr/bin/env bash
# Shows that a bare system is enough: makes a minimal Debian 12, unpacks an archive of the tree into it (no git) and
# runs tools/demo.sh, then tools/test.sh there. Needs root, debootstrap and about 6 GB.
#
#   tools/bootstrap-check.sh [ARCHIVE.tar]      the archive to check; without it `git archive HEAD`
#
# The results, out/ and the log among them, are copied to build/bootstrap-check/. The minimal system is kept in
# $TMPDIR/nephrite-bookworm.tar for the next time. The mirror is the one this machine's own apt uses; if it is not a
# Debian 12, name one in NEPHRITE_MIRROR.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

release=bookworm
scratch=${TMPDIR:-/tmp}
base=$scratch/nephrite-$release.tar
results=$PWD/build/bootstrap-check

if [[ $(id -u) -ne 0 ]]; then
    echo "bootstrap-check: needs root for chroot and mount" >&2
    exit 1
fi

root=$(mktemp -d "$scratch/nephrite-root-XXXXXX")
checks=
# Ends what still runs in the new system. Its mounts go with its mount namespace, so this removes only our own files.
clean_up() {
    [[ -z $checks ]] || kill "$checks" 2>/dev/null || true
    wait
    rm -rf --one-file-system "$root"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

mirror() {
    local own
    own=$(apt-get indextargets --format '$(REPO_URI)' "Codename: $release" 'Created-By: Packages' | head -n 1)
    echo "${NEPHRITE_MIRROR:-$own}"
}

make_base() {
    local uri
    uri=$(mirror)
    if [[ -z $uri ]]; then
        echo "bootstrap-check: this machine's apt knows no $release; name a mirror in NEPHRITE_MIRROR" >&2
        exit 1
    fi
    debootstrap --variant=minbase "$release" "$root" "$uri"
    tar -C "$root" -cf "$base.part" .
    mv "$base.part" "$base"
}

# The chroot reaches the mirror the way this machine does: names, proxies and credentials.
copy_network_settings() {
    cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
    apt-config dump | grep -E '^Acquire::(.*::Proxy|Check-|Retries|https?::)' >"$root/etc/apt/apt.conf.d/90host" || true
    cp -r /etc/apt/auth.conf.d/. "$root/etc/apt/auth.conf.d/"
}

# Runs a command in the new system, with its own mounts and processes and hardly any environment; it ends when the
# shell that waits for it does.
enter() {
    setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child --propagation private bash -c '
        set -e
        root=$1
        shift
        mount -t proc proc "$root/proc"
        mount -t sysfs -o ro sysfs "$root/sys"
        mount -t tmpfs tmpfs "$root/dev/shm"
        mount -t devpts devpts "$root/dev/pts"
        exec chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"
    ' enter "$root" "$@"
}

timed() {
    local start=$SECONDS
    echo "== $*"
    enter "$@"
    echo "== $* took $((SECONDS - start)) s"
}

if [[ -f $base ]]; then
    tar -C "$root" -xf "$base"
else
    make_base
fi
copy_network_settings

mkdir "$root/nephrite"
if [[ $# -gt 0 ]]; then
    tar -C "$root/nephrite" -xf "$1"
else
    git archive HEAD | tar -C "$root/nephrite" -xf -
fi

rm -rf "$results"
mkdir -p "$results"
{
    # Started from elsewhere, as the scripts promise to work from any folder.
    timed /nephrite/tools/demo.sh
    timed /nephrite/tools/test.sh
} > >(tee "$results/log.txt") 2>&1 &
checks=$!
wait "$checks"
checks=
cp -r "$root/nephrite/out" "$results/"
echo "bootstrap-check: passed; the pictures are in ${results#"$PWD"/}/out"
