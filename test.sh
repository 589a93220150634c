#!/usr/bin/env bash
# Installs what is missing (Debian 12), builds with warnings as errors, and runs all tests.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
. Testing/Support/set-up.sh

# Prints "N passed, N failed, N skipped" from the report that ctest writes.
summary()
{
  local counts
  counts=$(grep -m 1 -A 8 '<testsuite' "$1" | tr '\n\t' '  ')
  count() { sed -E "s/.* $1=\"([0-9]+)\".*/\1/" <<<"$counts"; }
  local failed skipped
  failed=$(count failures)
  skipped=$(($(count skipped) + $(count disabled)))
  echo "$(($(count tests) - failed - skipped)) passed, $failed failed, $skipped skipped"
}

setUp "${packages[@]}" "${testPackages[@]}"
VARIMARCH_HEAD_CT=$(headCt)
export VARIMARCH_HEAD_CT
build dev all 12

step "Testing"
report=$PWD/build/dev/tests.xml
rm -f "$report"
result=0
ctest --preset dev --parallel 2 --no-tests=error --output-junit "$report" || result=$?
[ -s "$report" ] || fail "ctest wrote no report to $report; its messages are above."
summary "$report"
exit $result
