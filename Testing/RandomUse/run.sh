#!/usr/bin/env bash
# run.sh ACTIONS [SEED]: random changes of a mapper's scene, and random actions in the viewer's window
# under Xvfb, ACTIONS of each, built by clang with assertions and the address and undefined-behaviour
# sanitizers. Ends with code 1 at the first fault, whose message has the seed and all actions before it.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

[[ "${1-}" =~ ^[0-9]+$ && "${2-1}" =~ ^[0-9]+$ ]] || fail "Usage: Testing/RandomUse/run.sh ACTIONS [SEED]"
export VARIMARCH_RANDOM_ACTIONS=$1 VARIMARCH_RANDOM_SEED=${2-1}

setUp "${packages[@]}" "${testPackages[@]}" "${fuzzPackages[@]}"
build fuzz TestRandomUse 8
build fuzz ViewerWindowTests 8

# Mesa's drivers leak. Memory that was freed is kept for a while, which must not look like growth.
export ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=16 UBSAN_OPTIONS=print_stacktrace=1

# succeeds COMMAND... runs a test, which fails too if VTK prints an error, or if none has this name.
succeeds()
{
  local log=build/fuzz/random-use.log result=0
  "$@" 2>&1 | tee "$log" || result=$?
  [ "$result" -eq 0 ] && ! grep -q 'ERR|' "$log" && grep -q '^\[  PASSED  \] 1 test' "$log"
}

step "$1 random changes of a mapper's scene"
succeeds build/fuzz/bin/TestRandomUse || fail "The mapper failed; its messages are above."
step "$1 random actions in the window"
QT_QPA_PLATFORM=xcb succeeds xvfb-run --auto-servernum \
  --server-args "-screen 0 1280x800x24 -noreset" build/fuzz/bin/ViewerWindowTests \
  --gtest_filter=RandomUse.SurvivesRandomActions || fail "The viewer failed; its messages are above."
