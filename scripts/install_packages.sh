#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Install missing Debian packages of the given groups, and print their names.
# usage: scripts/install_packages.sh GROUP...      groups: see scripts/packages.txt
set -eu
cd "$(dirname "$0")/.."

wanted=$(awk -v groups=" $* " '!/^#/ && index(groups, " " $1 " ") {print $2}' scripts/packages.txt)

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This machine has no apt. Install the equivalents of these Debian packages:" $wanted
    exit 0
fi

installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
            awk '$1 == "installed" {print $2}' || true)
missing=""
for package in $wanted; do
    grep -qx "$package" <<<"$installed" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "Installing Debian packages:$missing"
run=""
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Needs root: run as root, or install sudo, or ask for these packages:$missing" >&2
        exit 1
    fi
    run="sudo"
fi
# A foreign package source without a response is no error: installation decides.
$run apt-get update -qq || echo "apt-get update failed in part; going on" >&2
$run env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >/dev/null
echo "Installed:$missing"
