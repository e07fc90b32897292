#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Pack the Python package of a build folder into a wheel, without network.
# usage: scripts/make_wheel.sh BUILD_FOLDER      result: BUILD_FOLDER/wheel/hawser-*.whl
set -eu
cd "$(dirname "$0")/.."
build=$(cd "$1" && pwd)
python=${HAWSER_PYTHON_EXECUTABLE:-/usr/bin/python3}
stage=$build/python/wheel
rm -rf "$stage" "$build/wheel"
mkdir -p "$stage/hawser" "$build/wheel"
cp -L "$build"/python/hawser/*.py "$build"/python/hawser/py.typed "$build"/python/hawser/*.pyi \
    "$build"/python/hawser/_core*.so "$stage/hawser/"
# The program draws pictures and serves live pages of sessions.
install -D "$build/bin/hawser" "$stage/hawser/bin/hawser"
cp python/setup.py "$stage/"
(cd "$stage" && "$python" setup.py -q bdist_wheel --dist-dir "$build/wheel" 2>/dev/null)
ls "$build"/wheel/*.whl
