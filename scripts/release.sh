#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Build the files of a release and check them. usage: scripts/release.sh [BUILD] [JOBS]
#
#   build/packages/hawser-VERSION.tar.gz     sources of the commit HEAD
#   build/packages/hawser_VERSION_ARCH.deb, libhawser-dev_VERSION_ARCH.deb
#   build/packages/tag.txt                   text for the tag vVERSION: its section of CHANGELOG.md
#
# The check unpacks both Debian packages into an empty folder. It runs a scene with the program
# there, builds tests/consumer with the libraries there and runs it. It compares the source archive
# with the commit.
set -eu -o pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
jobs=${2:-$(nproc)}
out=build/packages
root=$PWD/$out/root

version=$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
if ! git diff --quiet HEAD; then
    echo "release.sh: files differ from HEAD; commit or stash them first" >&2
    exit 1
fi
rm -rf "$out"
mkdir -p "$out"

echo "--- text of the tag v$version"
awk -v version="$version" '
    /^## \[/ {shown = index($0, "[" version "]") == 4}
    shown {print}' CHANGELOG.md >"$out/tag.txt"
if [ ! -s "$out/tag.txt" ]; then
    echo "release.sh: CHANGELOG.md has no section '## [$version]'" >&2
    exit 1
fi

echo "--- sources"
git archive --format=tar.gz --prefix="hawser-$version/" -o "$out/hawser-$version.tar.gz" HEAD
mkdir "$out/sources"
tar -xzf "$out/hawser-$version.tar.gz" -C "$out/sources"
git ls-files | while read -r file; do
    [ -L "$file" ] || cmp -s "$file" "$out/sources/hawser-$version/$file" ||
        { echo "release.sh: $file is missing in the archive or differs" >&2; exit 1; }
done
rm -r "$out/sources"

echo "--- Debian packages"
cmake --build "$build" -j "$jobs" --target hawser_program
(cd "$build" && cpack -G DEB -B "$OLDPWD/$out" >"$OLDPWD/$out/cpack.log" 2>&1) ||
    { cat "$out/cpack.log" >&2; exit 1; }
rm -rf "$out/_CPack_Packages"

echo "--- check in an empty folder"
mkdir "$root"
for package in "$out"/*.deb; do
    dpkg-deb --info "$package" | sed -n 's/^ \(Package\|Version\|Depends\|Installed-Size\):/  \1:/p'
    dpkg-deb --extract "$package" "$root"
done
"$root/usr/bin/hawser" --version
"$root/usr/bin/hawser" run "$root/usr/share/hawser/scenes/heavy_hook.json" --duration 1 --quiet
cmake -S tests/consumer -B "$out/consumer" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$root/usr" >"$out/consumer.log"
cmake --build "$out/consumer" -j "$jobs" >>"$out/consumer.log"
"$out/consumer/consumer"
"$out/consumer/session" "$root/usr/share/hawser/scenes/anchor_lines.json" "$out/run.hwr"
"$root/usr/bin/hawser" replay "$out/run.hwr" --threads 2
(cd "$out" && sha256sum ./*.tar.gz ./*.deb | tee SHA256SUMS)
echo "release files: $out. Tag: git tag -a v$version -F $out/tag.txt"
