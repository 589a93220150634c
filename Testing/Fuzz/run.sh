#!/usr/bin/env bash
# run.sh MINUTES [TARGET...]: builds the fuzz targets with clang, and runs each of them, or the named
# ones, for MINUTES. Prints a table of executions, coverage and findings. Corpora and findings are
# kept in build/fuzz/corpora and build/fuzz/findings, so that a run goes on where the last one ended.
# An input that failed becomes a test if it is moved to Testing/Fuzz/Regressions/TARGET.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

usage="Usage: Testing/Fuzz/run.sh MINUTES [TARGET...]"
[[ "${1-}" =~ ^[0-9]+([.][0-9]+)?$ ]] || fail "$usage"
seconds=$(awk "BEGIN { print int(60 * $1) }")
shift

setUp "${packages[@]}" "${testPackages[@]}" clang libclang-rt-14-dev
build fuzz fuzz 15
build fuzz fuzz-seeds 1

bin=build/fuzz/bin
corpora=build/fuzz/corpora
findings=build/fuzz/findings
mkdir -p "$corpora" "$findings"
# Inputs are written and read thousands of times a second, best in memory. A target that crashes
# leaves them behind.
place=$(mktemp --directory --tmpdir="$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)")
trap 'rm -rf "$place"' EXIT
export TMPDIR=$place
mapfile -t known < <("$bin/fuzz-seeds" "$corpora")
targets=("$@")
[ $# -gt 0 ] || targets=("${known[@]}")

# Memory that is not touched is not taken: libraries of others ask for as much as a file promises, and
# are refused by limits of the process. Own readers check sizes first.
options=(-max_total_time="$seconds" -timeout=25 -rss_limit_mb=4000 -close_fd_mask=3
  -print_final_stats=1 -reload=0)
foreign=" dicom dicom-folder dicomdir minc tiff pictures vti pvti vtk archive inv3 "

# fuzzTarget NAME runs a target, and prints its row of the table.
fuzzTarget()
{
  local log=$findings/$1.log before after limit=1500
  [[ "$foreign" != *" $1 "* ]] || limit=100000
  mkdir -p "$findings/$1"
  before=$(find "$findings/$1" -type f | wc -l)
  local dictionary=()
  [ ! -s "$corpora/$1.dict" ] || dictionary=(-dict="$corpora/$1.dict")
  VARIMARCH_FUZZ_TARGET=$1 "$bin/fuzz" "${options[@]}" "${dictionary[@]}" \
    -malloc_limit_mb=$limit -artifact_prefix="$findings/$1/" "$corpora/$1" >"$log" 2>&1 || true
  after=$(find "$findings/$1" -type f | wc -l)
  printf '%-18s %12s %9s %9s %9s\n' "$1" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
    "$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -c6-)" \
    "$(grep -o 'ft: [0-9]*' "$log" | tail -n 1 | cut -c5-)" $((after - before))
}

printf '%-18s %12s %9s %9s %9s\n' target executions edges features findings
for target in "${targets[@]}"
do
  [ -d "$corpora/$target" ] || fail "expected a target (${known[*]}), found $target"
  fuzzTarget "$target"
done
