#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Install the Debian packages of scripts/release.sh in a bare Debian 12 with apt, so that their
# dependencies count. There, run a scene, build tests/consumer with the installed libraries, record
# a session with it, and replay the recording.
# usage: scripts/test_release_bare.sh [FOLDER]     needs root, debootstrap, git and about 2 GB
#   FOLDER   folder of the root, kept afterwards; by default a temporary one, removed.
#   MIRROR   (environment) package source: scripts/bare_root.sh.
set -eu
cd "$(dirname "$0")/.."
. scripts/bare_root.sh
packages=$(ls build/packages/*.deb 2>/dev/null) || fail "no packages in build/packages: run make release"
enter_name_space "$@"

root=${1:-}
if [ -z "$root" ]; then
    root=$(mktemp -d "${TMPDIR:-/tmp}/hawser_packages.XXXXXX")
    trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
fi
mkdir -p "$root"
root=$(cd "$root" && pwd)
make_root "$root"
mount -t proc proc "$root/proc"

start=$SECONDS
rm -rf "$root/packages" "$root/consumer"
mkdir "$root/packages"
# shellcheck disable=SC2086
cp $packages "$root/packages"
cp -r tests/consumer "$root/consumer"
inside "$root" sh -eu -c '
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq
    echo "=== the program alone"
    apt-get install -y -qq --no-install-recommends ./packages/hawser_*.deb >/dev/null
    hawser --version
    hawser run /usr/share/hawser/scenes/heavy_hook.json --duration 1 --quiet
    echo "=== the library"
    apt-get install -y -qq --no-install-recommends ./packages/libhawser-dev_*.deb g++ cmake make \
        >/dev/null
    cmake -S /consumer -B /consumer/build -DCMAKE_BUILD_TYPE=Release >/dev/null
    cmake --build /consumer/build >/dev/null
    /consumer/build/consumer
    /consumer/build/session /usr/share/hawser/scenes/anchor_lines.json /consumer/run.hwr
    hawser replay /consumer/run.hwr --threads 2 --quiet
    echo "=== removal leaves no files"
    apt-get remove -y -qq hawser libhawser-dev >/dev/null
    ! find /usr -path "*hawser*" -not -type d | grep .
'
echo "=== the packages work in a bare Debian 12: passed, $((SECONDS - start)) s"
