#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Run the first two commands of a user, `make demo` and `make test`, on a bare Debian 12. A root made
# by debootstrap gets the files of the last commit and the network of this machine.
# usage: scripts/test_bare.sh [FOLDER]     needs root, debootstrap, git and about 3 GB
#   FOLDER   folder of the root, kept afterwards; by default a temporary one, removed.
#   MIRROR   (environment) package source: scripts/bare_root.sh.
set -eu
cd "$(dirname "$0")/.."
. scripts/bare_root.sh
enter_name_space "$@"

root=${1:-}
if [ -z "$root" ]; then
    root=$(mktemp -d "${TMPDIR:-/tmp}/hawser_bare.XXXXXX")
    trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
fi
mkdir -p "$root"
root=$(cd "$root" && pwd)
make_root "$root"
mount -t proc proc "$root/proc"
put_sources "$root"

echo "=== make demo && make test"
start=$SECONDS
inside "$root" sh -c 'cd /hawser && make demo && make test'
echo "=== a bare Debian 12 runs make demo and make test: passed, $((SECONDS - start)) s"
