#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
#
# Write the golden files of tests/golden: figures of scenes and outputs of the program.
#
# Run it only if results are meant to change. Read the diff: each change in it needs a reason. Give
# the largest difference of the figures in the body of the commit.
#
#   scripts/write_golden.sh [BUILD_FOLDER]     default: build/release; build it first
#
# References are those of SSE2. Tolerances of figures follow from the differences to AVX2 and
# AVX-512: use a machine that has both. To change the length of a scene's run, edit "steps" in
# tests/golden/scene_figures.json first.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
export HAWSER_BIN_DIR="$build/bin"
test=$build/bin/hawser_test_golden

sets=sse2
for isa in avx2 avx512; do
    if grep -q "$isa" /proc/cpuinfo; then
        sets="$sets $isa"
    else
        echo "write_golden.sh: this machine has no $isa: tolerances may be too small" >&2
    fi
done

rm -rf tests/golden/outputs
for isa in $sets; do
    filter='*/SceneFigures.*'
    [ "$isa" = sse2 ] && filter='*'
    HAWSER_WRITE_GOLDEN=1 HAWSER_ISA=$isa "$test" --gtest_brief=1 --gtest_filter="$filter"
done
for isa in $sets; do
    echo "compare with $isa"
    HAWSER_ISA=$isa "$test" --gtest_brief=1
done
git diff --stat -- tests/golden
