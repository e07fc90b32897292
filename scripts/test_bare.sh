#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# The two first commands of a user, `make demo` and `make test`, on a bare Debian 12: a root made
# by debootstrap gets the files of the last commit and nothing of this machine but its network.
# usage: scripts/test_bare.sh [FOLDER]     needs root, debootstrap, git and about 3 GB
#   FOLDER   where the root is made, kept afterwards; by default a temporary one, removed.
#   MIRROR   (environment) package source; by default the one that this machine uses for Debian 12,
#            else deb.debian.org.
set -eu
cd "$(dirname "$0")/.."

fail() {
    echo "test_bare: $*" >&2
    exit 1
}
[ "$(id -u)" -eq 0 ] || fail "making a root needs root; try: sudo make test-bare"
for program in debootstrap git chroot unshare; do
    command -v "$program" >/dev/null || fail "$program is missing: apt-get install $program"
done

release=bookworm
mirror=${MIRROR:-}
if [ -z "$mirror" ] && command -v apt-get >/dev/null; then
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' \
        "Codename: $release" 'Component: main' 2>/dev/null | head -1)
fi
mirror=${mirror:-http://deb.debian.org/debian}

# What is mounted is gone with the name space, however this ends.
if [ "${HAWSER_BARE_INSIDE:-}" != 1 ]; then
    exec env HAWSER_BARE_INSIDE=1 unshare --mount --propagation private "$0" "$@"
fi

root=${1:-}
if [ -z "$root" ]; then
    root=$(mktemp -d "${TMPDIR:-/tmp}/hawser_bare.XXXXXX")
    trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
fi
mkdir -p "$root"
root=$(cd "$root" && pwd)

if [ ! -x "$root/usr/bin/make" ]; then
    echo "=== a bare Debian 12 in $root"
    debootstrap --variant=minbase --include=make,ca-certificates "$release" "$root" "$mirror" \
        >"$root.log" 2>&1 || { tail -5 "$root.log" >&2; fail "debootstrap failed: $root.log"; }
    rm -f "$root.log"
fi
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
apt-config dump 2>/dev/null | grep -i '^Acquire::[a-z]*::Proxy' >"$root/etc/apt/apt.conf.d/90proxy" ||
    true

git diff --quiet HEAD || echo "test_bare: what is not committed is not tested" >&2
rm -rf "$root/hawser"
mkdir "$root/hawser"
git archive HEAD | tar -x -C "$root/hawser"

echo "=== make demo && make test"
start=$SECONDS
env -i HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    chroot "$root" sh -c 'cd /hawser && make demo && make test'
echo "=== a bare Debian 12 runs make demo and make test: passed, $((SECONDS - start)) s"
