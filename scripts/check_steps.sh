# SPDX-License-Identifier: Apache-2.0
#
# Functions of .ci/run and scripts/check_full.sh: run named steps, go on after a failure, report.
# A caller sets `log`, a file for all output.
passed=0
failed=""
times=""  # one line per step

step() {  # step NAME COMMAND...: run the command, print its wall and processor time
    local name=$1
    shift
    echo
    echo "=== $name"
    local TIMEFORMAT="=== $name: %R s, processor %U s + system %S s" result=0
    { time "$@" 2>&1 | tee -a "$log"; } 2>"$log.time" || result=$?
    tail -n 1 "$log.time"
    times="$times$(tail -n 1 "$log.time")"$'\n'
    rm -f "$log.time"
    if [ "$result" -eq 0 ]; then
        passed=$((passed + 1))
        echo "=== $name: passed"
    else
        failed="$failed $name"
        echo "=== $name: FAILED"
    fi
}

summary() {  # summary: print times and counts; fail if a step failed
    local ran broken
    # Sum lines such as "100% tests passed, 0 tests failed out of 123".
    read -r ran broken < <(awk '/tests failed out of/ {n += $NF; f += $4} END {print n + 0, f + 0}' "$log")
    printf '\n%s' "$times"
    echo "$((ran - broken)) test processes passed, $broken failed; $passed steps passed," \
         "$(wc -w <<<"$failed") failed${failed:+:$failed}; $SECONDS s"
    [ -z "$failed" ]
}

words() {  # check the project's words, once the script exists
    [ ! -x scripts/check_words.py ] || scripts/check_words.py
}

tidy() {  # tidy BASE SECONDS: clang-tidy on what changed since BASE; empty: lately
    cmake --preset relassert >/dev/null && scripts/tidy.py --build build/relassert ${1:+--base "$1"} --budget "$2"
}

sanitized() {  # sanitized PRESET FOLDER...: quick tests of these folders; none: of all
    local preset=$1
    shift
    cmake --preset "$preset" >/dev/null &&
        scripts/run_tests.py --preset "$preset" ${1:+--folders "$@"}
}

threads() {  # tests of several threads under the thread sanitizer
    # g++ 12's thread sanitizer rejects the address layout of recent kernels: fix the layout if the
    # container permits it.
    local fixed_layout=""
    if setarch "$(uname -m)" -R true 2>/dev/null; then
        fixed_layout="setarch $(uname -m) -R"
    fi
    cmake --preset tsan >/dev/null &&
        $fixed_layout scripts/run_tests.py --preset tsan --folders runtime threads
}
