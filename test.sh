#!/usr/bin/env bash
# Installs missing packages (Debian 12), builds with warnings as errors, and runs all tests.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
. Testing/Support/set-up.sh

setUp "${packages[@]}" "${testPackages[@]}"
VARIMARCH_HEAD_CT=$(headCt)
export VARIMARCH_HEAD_CT
build dev all 11

step "Testing"
report=$PWD/build/dev/tests.xml
reportsOfSuites=$PWD/build/dev/Testing/reports
rm -rf "$report" "$reportsOfSuites"
result=0
ctest --preset dev --parallel $(($(nproc) + 1)) --no-tests=error --output-junit "$report" || result=$?
[ -s "$report" ] || fail "ctest wrote no report to $report; its messages are above."
python3 Testing/Support/count_tests.py "$report" "$reportsOfSuites"
exit $result
