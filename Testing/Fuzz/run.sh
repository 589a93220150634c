#!/usr/bin/env bash
# run.sh MINUTES [TARGET...]: builds the fuzz targets with clang, and runs each of them, or the named
# ones, for MINUTES of processor time, as many at a time as there are processors (taskset limits
# them). A run of less than a minute is limited by the clock instead, has one more at a time, since
# some wait for the decoder, and begins with the same random numbers each time. Targets with the fewest inputs so far come first. Prints a table of executions, coverage and
# findings, and ends with code 3 if there are findings, which it prints if they are short. It may be
# interrupted by Ctrl+C.
#
# Corpora, findings and figures of all runs are kept in build/fuzz/corpora, build/fuzz/findings and
# build/fuzz/runs.txt, so that a run goes on where the last one ended. An input that failed becomes a
# test if it is moved to Testing/Fuzz/Regressions/TARGET.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

usage="Usage: Testing/Fuzz/run.sh MINUTES [TARGET...]"
[[ "${1-}" =~ ^[0-9]+([.][0-9]+)?$ ]] || fail "$usage"
seconds=$(awk "BEGIN { print int(60 * $1 + 0.5) }")
[ "$seconds" -gt 0 ] || fail "expected at least a second, found $1 minutes. $usage"
shift

setUp "${packages[@]}" "${testPackages[@]}" "${fuzzPackages[@]}"
build fuzz fuzz 6
build fuzz fuzz-seeds 1

bin=build/fuzz/bin
corpora=build/fuzz/corpora
findings=build/fuzz/findings
runs=build/fuzz/runs.txt
mkdir -p "$corpora" "$findings"
touch "$runs"
# Inputs are written and read thousands of times a second, best in memory. A target that crashes
# leaves them behind.
place=$(mktemp --directory --tmpdir="$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)")
trap 'rm -rf "$place"' EXIT
export TMPDIR=$place
mapfile -t known < <("$bin/fuzz-seeds" "$corpora")

# Memory that is not touched is not taken: libraries of others ask for as much as a file promises, and
# are refused by limits of the process. Own readers check sizes first. A target that waits for other
# programs, such as the decoder, may take four times as long as its processor time.
mostSeconds=$((seconds < 60 ? seconds : 4 * seconds))
options=(-max_total_time=$mostSeconds -timeout=60 -report_slow_units=60 -rss_limit_mb=4000
  -close_fd_mask=3 -print_final_stats=1 -reload=0)
# A run of less than a minute is a check of a change, whose inputs should depend little on chance.
[ "$seconds" -ge 60 ] || options+=(-seed=1)
foreign=" dicom dicom-compressed dicom-folder dicomdir minc tiff pictures vti pvti vtk archive inv3 "

# inputsOf NAME... prints the names with the number of inputs of all runs, fewest first.
inputsOf()
{
  awk 'FILENAME == ARGV[1] { inputs[$1] += $2; next } { print inputs[$1] + 0, $1 }' \
    "$runs" <(printf '%s\n' "$@") | sort -n -s -k 1,1
}

# lastOf PATTERN FILE prints the number behind the last match, or 0.
lastOf()
{
  grep -oE "$1 *[0-9]+" "$2" | tail -n 1 | grep -oE '[0-9]+$' || echo 0
}

# secondsOfChildren prints the processor time of the programs that this shell has waited for.
secondsOfChildren()
{
  times >"$place/$BASHPID"
  awk 'NR == 2 { split($1 "m" $2, t, "[ms]+"); print int(60 * (t[1] + t[3]) + t[2] + t[4] + 0.5) }' \
    "$place/$BASHPID"
}

# keepReports NAME appends the sanitizers' reports to the log, and returns 1 if there are any from the
# decoder, whose end is a sentence for its reader. Crashes of libraries there are no findings, nor is
# a lack of memory.
keepReports()
{
  local report result=0
  for report in "$place/$1".report.*
  do
    if grep -qsE 'runtime error: |(Address|Leak)Sanitizer: (heap|stack|global|dynamic|use|double|container|bad|detected)' "$report"
    then
      cat "$report" >>"$findings/$1.log"
      result=1
    fi
    rm -f "$report"
  done
  return $result
}

# fuzzTarget NAME runs a target, prints its row of the table, and adds it to those of earlier runs.
fuzzTarget()
{
  local log=$findings/$1.log limit=1500 result=0 row dictionary=()
  [[ "$foreign" != *" $1 "* ]] || limit=100000
  [ ! -s "$corpora/$1.dict" ] || dictionary=(-dict="$corpora/$1.dict")
  mkdir -p "$findings/$1"
  touch "$place/$1.started"
  VARIMARCH_FUZZ_TARGET=$1 VARIMARCH_FUZZ_SECONDS=$seconds \
    ASAN_OPTIONS=handle_segv=0:log_path=$place/$1.report "$bin/fuzz" "${options[@]}" \
    "${dictionary[@]}" -malloc_limit_mb=$limit -artifact_prefix="$findings/$1/" "$corpora/$1" \
    >"$log" 2>&1 &
  echo $! >"$place/$1.process"
  wait $! || result=$?
  rm "$place/$1.process"
  # An interrupt ends libFuzzer with the code 72.
  [ "$result" -ne 72 ] || result=0
  keepReports "$1" || result=1
  [ "$result" -eq 0 ] || touch "$place/$1.failed"
  secondsOfChildren >"$place/$1.seconds"
  row=$(printf '%-18s %12s %9s %9s %9s %9s' "$1" "$(lastOf number_of_executed_units: "$log")" \
    "$(cat "$place/$1.seconds")" "$(lastOf cov: "$log")" "$(lastOf ft: "$log")" "$((result != 0))")
  echo "$row" | tee -a "$runs"
}

# showInput FILE prints its name, and its bytes for base64 --decode if they are few.
showInput()
{
  echo "$1"
  [ "$(stat --format %s "$1")" -gt 3000 ] || base64 "$1"
}

# showFindings prints each target that failed, its input and the reason; it returns 3 if there are any.
showFindings()
{
  local failed name input result=0
  for failed in "$place"/*.failed
  do
    [ -e "$failed" ] || continue
    result=3
    name=$(basename "$failed" .failed)
    printf '\nThe target %s failed. The log is %s, the input is:\n' "$name" "$findings/$name.log"
    for input in $(find "$findings/$name" -type f -newer "$place/$name.started")
    do
      showInput "$input"
    done
    grep -m 5 -E 'ERROR: |The target failed: |VTK printed: |runtime error: |SUMMARY: |cannot be run: ' \
      "$findings/$name.log" || true
  done
  return $result
}

interrupt()
{
  isInterrupted=1
  cat "$place"/*.process 2>/dev/null | xargs -r kill -INT 2>/dev/null || true
}

mapfile -t targets < <(inputsOf "${@:-${known[@]}}" | cut -d ' ' -f 2)
for target in "${targets[@]}"
do
  [ -d "$corpora/$target" ] || fail "expected a target (${known[*]}), found $target"
done

atATime=$(($(nproc) + (seconds < 60)))
step "Running ${#targets[@]} targets for $seconds s each, $atATime at a time"
isInterrupted=
trap interrupt INT TERM
printf '%-18s %12s %9s %9s %9s %9s\n' target executions seconds edges features findings
for target in "${targets[@]}"
do
  while [ "$(jobs -pr | wc -l)" -ge "$atATime" ]
  do
    wait -n || true
  done
  [ -z "$isInterrupted" ] || break
  fuzzTarget "$target" &
done
while [ "$(jobs -pr | wc -l)" -gt 0 ]
do
  wait || true
done
result=0
showFindings || result=$?
[ -z "$isInterrupted" ] || result=130
exit $result
