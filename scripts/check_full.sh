#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Run all checks of a night: all suites of the full tier, all sanitizers over all
# folders, the benchmark libraries.
#
# usage: scripts/check_full.sh [--again]
#
# A step that passed for the present sources is not repeated: interrupt it and start it again.
# --again forgets the passed steps.
set -u -o pipefail
cd "$(dirname "$0")/.."
sources=$( (git rev-parse HEAD; git diff HEAD; git ls-files -o --exclude-standard -z | xargs -0 -r sha1sum) |
    sha1sum | cut -c1-12)
marks=build/check-full/$sources
[ "${1:-}" != --again ] || rm -rf "$marks"
mkdir -p "$marks"
log=$marks/log
. scripts/check_steps.sh

once() {  # once NAME COMMAND...: a step, unless it passed before
    if [ -e "$marks/$1.passed" ]; then
        echo "=== $1: passed before"
        passed=$((passed + 1))
        return
    fi
    local before=$passed
    step "$@"
    [ "$passed" -eq "$before" ] || touch "$marks/$1.passed"
}

libraries() {  # programs that link foreign engines, and their tests
    cmake --preset release -DHAWSER_BENCH_LIBRARIES=ON >/dev/null &&
        cmake --build --preset release --target hawser_bench hawser_program &&
        scripts/run_tests.py --tier full --folders bench cli
}

once packages scripts/install_packages.sh build bench check
once format make -s format-check
once layers scripts/check_layers.py
once words words
once test-full make test-full
once libraries libraries
once asan-ubsan sanitized asan-ubsan
once tsan threads
once tidy tidy "" 600
summary
