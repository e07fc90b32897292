#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Build the page of `hawser view` and embed it.  usage: scripts/build_page.sh OUT
#
# Installs Debian's nodejs and npm if they are missing, and packages of package-lock.json that are
# missing in node_modules. Writes OUT/page_files.cpp. A second run needs no network.
set -eu
cd "$(dirname "$0")/.."
out=$(realpath -m "${1:-build/page}")

if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    scripts/install_packages.sh page
fi
major=$(node --version | sed 's/^v\([0-9]*\).*/\1/')
if [ "$major" -lt 18 ]; then
    echo "node $(node --version) is too old: the page needs 18 or newer (Debian 12 has 18)" >&2
    exit 1
fi

cd apps/view/page
if ! cmp -s package-lock.json node_modules/.installed-lock; then
    echo "page: npm ci"
    npm ci --no-audit --no-fund --loglevel=error
    cp package-lock.json node_modules/.installed-lock
fi
node build.mjs "$out"
