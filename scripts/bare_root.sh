# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
#
# Functions for scripts that test the project in a bare Debian 12 (test_bare.sh, test_view_bare.sh).
# They source this file in the root of the source tree.
#   MIRROR   (environment) package source; by default the one that this machine uses for Debian 12,
#            else deb.debian.org.

fail() {
    echo "$(basename "$0" .sh): $*" >&2
    exit 1
}

# Check that this machine can make roots. Later mounts end with the name space.
# usage: enter_name_space "$@"
enter_name_space() {
    [ "$(id -u)" -eq 0 ] || fail "making a root needs root; try with sudo"
    for program in debootstrap git chroot unshare; do
        command -v "$program" >/dev/null || fail "$program is missing: apt-get install $program"
    done
    [ "${HAWSER_BARE_INSIDE:-}" = 1 ] ||
        exec env HAWSER_BARE_INSIDE=1 unshare --mount --propagation private "$0" "$@"
}

# Make a bare Debian 12 with make, if there is none yet, with the network settings of this machine.
# usage: make_root ROOT
make_root() {
    local root=$1 release=bookworm mirror=${MIRROR:-}
    if [ -z "$mirror" ] && command -v apt-get >/dev/null; then
        mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' \
            "Codename: $release" 'Component: main' 2>/dev/null | head -1)
    fi
    mirror=${mirror:-http://deb.debian.org/debian}
    if [ ! -x "$root/usr/bin/make" ]; then
        echo "=== a bare Debian 12 in $root"
        debootstrap --variant=minbase --include=make,ca-certificates "$release" "$root" "$mirror" \
            >"$root.log" 2>&1 || { tail -5 "$root.log" >&2; fail "debootstrap failed: $root.log"; }
        rm -f "$root.log"
    fi
    apt-config dump 2>/dev/null | grep -i '^Acquire::[a-z]*::Proxy' \
        >"$root/etc/apt/apt.conf.d/90proxy" || true
    cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
    # A gateway of the network may sign certificates itself.
    if ls /usr/local/share/ca-certificates/*.crt >/dev/null 2>&1; then
        cp /usr/local/share/ca-certificates/*.crt "$root/usr/local/share/ca-certificates"
        inside "$root" update-ca-certificates >/dev/null 2>&1
    fi
}

# Put the files of the last commit into a folder of a root.   usage: put_sources ROOT [PLACE]
put_sources() {
    git diff --quiet HEAD || echo "$(basename "$0" .sh): what is not committed is not tested" >&2
    local to=$1${2:-/hawser}
    rm -rf --one-file-system "$to"
    mkdir -p "$to"
    git archive HEAD | tar -x -C "$to"
}

# Run a command in a root, without this machine's environment. Node does not use the system's
# certificates by default.   usage: inside ROOT COMMAND...
inside() {
    local root=$1
    shift
    env -i HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt chroot "$root" "$@"
}
