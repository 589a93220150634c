#!/usr/bin/env bash
# run.sh [RANKS...]
#
# Builds the plugin VarimarchVolume for Debian 12's ParaView 5.11 and draws with it: in pvbatch on one
# process, whose pictures are compared with exact ones, then on 2, 4 and 8 (or RANKS) processes, whose
# pictures are compared with those of one, and in a pvserver of two. Stock ParaView draws the same.
# The tables are in build/paraview-test/report.md. Exit code 1: a picture differs too much.
#
# ParaView is unpacked below build, because its Python modules and those of Debian's VTK exclude each
# other. About 15 minutes on two free cores.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

prefix=$PWD/build/paraview-5.11/usr
plugin=$PWD/build/paraview/lib/x86_64-linux-gnu/paraview-5.11/plugins/VarimarchVolume/VarimarchVolume.so
pictures=$PWD/build/paraview-test
report=$pictures/report.md
ranks=("${@:-2 4 8}")
read -ra ranks <<<"${ranks[*]}"
cases=(composite behind lit opaque turned oblique cropped geometry inside two cells uneven block partition
  blocks cell)
# Scenes of Data/References with a light at the eye, or with none.
references=(torso-soft torso-soft-lit torso-parallel shells-thin-peak)
# Least ratios of the pictures of several processes to that of one [dB], in floats: with the default
# tolerance, and with one so small that what is left is the compositing.
leastDecibels=70
smallTolerance=0.0001
leastDecibelsOfFloats=90
# The same of pictures in floats that are rounded to 8 bits in the end.
leastDecibelsOfRounded=60
# The same for ParaView's 8 bits, whose rounding alone is 59 dB for a part and adds up over the parts
# behind each other.
leastDecibelsOfBytes=50
# Largest error of a picture with one process; 8 bits alone are 0.29 [1/255].
mostError=0.6
failures=0

# Prints the packages that a downloaded one depends on, without ParaView's own, and without those of
# its web server and its text in formulas.
dependenciesOf()
{
  dpkg-deb --field "$1" Depends | tr ',' '\n' |
    sed -E 's/^ *//; s/[ (|].*//; s/:any//' |
    grep -vE '^(paraview|python3-(autobahn|twisted|matplotlib|mpi4py))$'
}

unpackParaView()
{
  [ -e "$prefix/bin/pvpython" ] && return
  local folder=build/paraview-5.11.partial package
  rm -rf "$folder"
  mkdir -p "$folder"
  aptGet update >"$packageLog" || true
  (cd "$folder" && LC_ALL=C apt-get --quiet download paraview paraview-dev python3-paraview) \
    >>"$packageLog" 2>&1 || failAsApt
  for package in "$folder"/*.deb
  do
    # shellcheck disable=SC2046
    installMissingPackages $(dependenciesOf "$package")
    dpkg-deb --extract "$package" "$folder"
    rm "$package"
  done
  mv "$folder" build/paraview-5.11
}

buildPlugin()
{
  cmake -S App/ParaView -B build/paraview -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_LIBRARY_ARCHITECTURE=x86_64-linux-gnu -DCMAKE_INSTALL_LIBDIR=lib/x86_64-linux-gnu \
    -DPython3_EXECUTABLE=/usr/bin/python3 -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 >build/paraview.log 2>&1 ||
    fail "CMake could not configure the plugin; see build/paraview.log"
  cmake --build build/paraview
}

# inParaView COMMAND... runs a program of ParaView in an X server of its own, which it needs even to
# draw off the screen.
inParaView()
{
  env PATH="$prefix/bin:$PATH" LD_LIBRARY_PATH="$prefix/lib/x86_64-linux-gnu" \
    PYTHONPATH="$prefix/lib/python3/dist-packages" \
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    timeout 900 xvfb-run -a -s "-screen 0 640x480x24 -nolisten tcp -noreset" "$@"
}

# draw RANKS REPRESENTATION FOLDER CASE... draws in pvbatch.
draw()
{
  local count=$1 representation=$2 folder=$pictures/$3
  shift 3
  mkdir -p "$folder"
  rm -f "$folder"/*.png "$folder"/*.floats
  inParaView mpiexec --oversubscribe -n "$count" pvbatch --force-offscreen-rendering \
    Testing/ParaView/draw.py "$plugin" "$representation" "$folder" "$@" >"$folder/log" 2>&1 ||
    { failures=$((failures + 1)); tail -n 5 "$folder/log"; }
}

# compare ARGUMENT... prints a comparison, which is counted in the report if it fails: a variable of
# this script would not keep a count of $(compare ...).
compare()
{
  local result
  result=$(/usr/bin/python3 Testing/ParaView/compare.py "$@") || result="${result:-no picture} (FAILED)"
  echo "$result"
}

row()
{
  echo "$*" | tee -a "$report"
}

testOneProcess()
{
  step "One process, against exact pictures"
  draw 1 "Volume (Varimarch)" exact "${references[@]}"
  draw 1 "Volume" exact-stock "${references[@]}"
  row "| scene | Varimarch | ParaView's Volume |"
  row "|---|---|---|"
  local name
  for name in "${references[@]}"
  do
    row "| $name | $(compare --reference "$name" "$pictures/exact/$name.png" "$mostError")" \
      "| $(compare --reference "$name" "$pictures/exact-stock/$name.png" 255) |"
  done
}

# The program of this tree draws the same scenes, with Debian's VTK. Its steps are those of a search that
# does not round them down, so that the pictures differ by errors within the tolerance.
testProgram()
{
  local program=build/dev/bin/varimarch name
  [ -x "$program" ] || { echo "Skipped: no $program; build the preset dev"; return; }
  row ""
  row "| scene | \`varimarch render\` |"
  row "|---|---|"
  for name in "${references[@]}"
  do
    python3 -c 'import json, sys; print(json.dumps(json.load(sys.stdin)["scene"]))' \
      <"Data/References/$name.json" >"$pictures/exact/$name.json"
    "$program" render "$pictures/exact/$name.json" -o "$pictures/exact/$name-program.png" >/dev/null
    row "| $name" \
      "| $(compare "$pictures/exact/$name-program.png" "$pictures/exact/$name.png" 50) |"
  done
}

# Scenes of Data/References, whose exact pictures do not depend on the number of processes.
testReferences()
{
  step "Several processes, against exact pictures"
  local count name line
  row ""
  row "| processes |$(printf ' %s |' "${references[@]}")"
  row "|---:|$(printf -- '---|%.0s' "${references[@]}")"
  for count in "${ranks[@]}"
  do
    draw "$count" "Volume (Varimarch)" "exact-$count" "${references[@]}"
    line="| $count"
    for name in "${references[@]}"
    do
      line+=" | $(compare --reference "$name" "$pictures/exact-$count/$name.png" "$mostError")"
    done
    row "$line |"
  done
}

# against KIND FOLDER LEAST [floats] compares the picture of a case to that of one process.
against()
{
  compare "$pictures/$1-1/$name.${4:-png}" "$pictures/$2/$name.${4:-png}" "$3"
}

# One process draws in floats what it may also draw in 8 bits, gives the window its depths, and goes on
# when another view is closed.
testOneInFloats()
{
  step "One process, in floats and in 8 bits"
  local name
  draw 1 "Volume (Varimarch)" floats-1 geometry toned composite closed
  VARIMARCH_BYTES=1 draw 1 "Volume (Varimarch)" bytes-1 geometry toned composite closed
  row ""
  for name in geometry toned closed
  do
    row "$name of one process in floats, against 8 bits:" "$(against floats bytes-1 "$leastDecibelsOfBytes")"
  done
  diff <(grep "least depth" "$pictures/floats-1/log") <(grep "least depth" "$pictures/bytes-1/log") ||
    { failures=$((failures + 1)); echo "FAILED: expected the same depths"; }
  ! grep "ERR|" "$pictures"/{floats,bytes}-1/log || failures=$((failures + 1))
}

testSeveralProcesses()
{
  step "Several processes, against one"
  local count name
  draw 1 "Volume (Varimarch)" ours-1 "${cases[@]}"
  draw 1 "Volume" stock-1 "${cases[@]}"
  row ""
  VARIMARCH_TOLERANCE=$smallTolerance draw 1 "Volume (Varimarch)" small-1 "${cases[@]}"
  row "Eight images in one process, against one image:" \
    "$(compare "$pictures/ours-1/block.floats" "$pictures/ours-1/blocks.floats" "$leastDecibels");" \
    "small tolerance" \
    "$(compare "$pictures/small-1/block.floats" "$pictures/small-1/blocks.floats" "$leastDecibelsOfFloats");" \
    "Volume $(compare "$pictures/stock-1/block.png" "$pictures/stock-1/blocks.png" 0)"
  row ""
  row "| case | processes | floats | rounded | small tolerance, floats | rounded | 8 bits | ParaView's Volume |"
  row "|---|---:|---|---|---|---|---|---|"
  for count in "${ranks[@]}"
  do
    draw "$count" "Volume (Varimarch)" "ours-$count" "${cases[@]}"
    VARIMARCH_BYTES=1 draw "$count" "Volume (Varimarch)" "bytes-$count" "${cases[@]}"
    VARIMARCH_TOLERANCE=$smallTolerance draw "$count" "Volume (Varimarch)" "small-$count" "${cases[@]}"
    draw "$count" "Volume" "stock-$count" "${cases[@]}"
    for name in "${cases[@]}"
    do
      row "| $name | $count" \
        "| $(against ours "ours-$count" "$leastDecibels" floats)" \
        "| $(against ours "ours-$count" "$leastDecibelsOfRounded")" \
        "| $(against small "small-$count" "$leastDecibelsOfFloats" floats)" \
        "| $(against small "small-$count" "$leastDecibelsOfRounded")" \
        "| $(against ours "bytes-$count" "$leastDecibelsOfBytes")" \
        "| $(against stock "stock-$count" 0) |"
    done
    # Where two volumes lie beside each other and are split along the line between them, some parts of
    # one process are in front of those of another process, and others are behind them.
    [ "$count" -ne 8 ] ||
      expectOnce "have parts in front of each other" "$pictures/ours-$count/log"
  done
}

# runOrderTest NAME builds and runs a test of the order of processes, whose output is in the report.
runOrderTest()
{
  cmake --build build/paraview --target "$1" >"$pictures/order-build.log" ||
    fail "the order of processes could not be built; see $pictures/order-build.log"
  LD_LIBRARY_PATH="$prefix/lib/x86_64-linux-gnu" "$(find build/paraview -name "$1" -type f)" |
    tee -a "$report" || failures=$((failures + 1))
}

testOrder()
{
  step "The order of many processes, and below passes that process the image"
  row ""
  runOrderTest OrderOfManyProcesses
  runOrderTest PassesOfViews
}

# All parts take the steps of the whole, whose search they share.
testSteps()
{
  step "Common steps"
  local count
  local -a lengths
  for count in 1 2 8
  do
    PARAVIEW_LOG_RENDERING_VERBOSITY=INFO draw "$count" "Volume (Varimarch)" "steps-$count" lit
  done
  mapfile -t lengths < <(sed -n "s/.*common steps \([0-9.]*\).*/\1/p" "$pictures"/steps-*/log | sort -u)
  echo "Lengths of common steps: ${lengths[*]}"
  [ "${#lengths[@]}" -eq 1 ] || failures=$((failures + 1))
}

# Prints the median time of a frame of a case in the log of a folder [ms].
frameTime()
{
  sed -n "s/^composite \([0-9][0-9]*\).*/\1/p" "$pictures/$1/log"
}

testTimes()
{
  step "Times"
  local count
  row ""
  row "| processes | Varimarch [ms] | in 8 bits [ms] | ParaView's Volume [ms] |"
  row "|---:|---:|---:|---:|"
  for count in 1 "${ranks[@]}"
  do
    PARAVIEW_LOG_RENDERING_VERBOSITY=INFO VARIMARCH_FRAMES=15 \
      draw "$count" "Volume (Varimarch)" "times-ours-$count" composite
    VARIMARCH_BYTES=1 VARIMARCH_FRAMES=15 draw "$count" "Volume (Varimarch)" "times-bytes-$count" composite
    VARIMARCH_FRAMES=15 draw "$count" "Volume" "times-stock-$count" composite
    row "| $count | $(frameTime "times-ours-$count") | $(frameTime "times-bytes-$count")" \
      "| $(frameTime "times-stock-$count") |"
  done
  row ""
  /usr/bin/python3 Testing/ParaView/scaling.py times "${ranks[@]/#/$pictures/times-ours-}" | tee -a "$report"
}

# A process that is killed while all draw must end the others, with a message of mpiexec.
testDeath()
{
  step "A process that dies"
  local code=0
  mkdir -p "$pictures/death"
  # shellcheck disable=SC2016
  VARIMARCH_FRAMES=100000 inParaView timeout 120 bash -c '
    mpiexec --oversubscribe -n 2 pvbatch --force-offscreen-rendering "$@" &
    sleep 40
    kill -9 "$(pgrep -P $! pvbatch | tail -n 1)"
    wait $!' bash Testing/ParaView/draw.py "$plugin" "Volume (Varimarch)" "$pictures/death" \
    composite >"$pictures/death/log" 2>&1 || code=$?
  expectMessage "signal 9" "$pictures/death/log"
  [ "$code" -ne 0 ] && [ "$code" -ne 124 ] || {
    failures=$((failures + 1))
    echo "FAILED: expected an exit code of mpiexec, found $code"
  }
}

# expectMessage TEXT FILE
expectMessage()
{
  grep -qF "$1" "$2" || {
    failures=$((failures + 1))
    echo "FAILED: expected the message \"$1\" in $2"
  }
}

# expectOnce TEXT FILE
expectOnce()
{
  local count
  count=$(grep -cF "$1" "$2" || true)
  [ "$count" -eq 1 ] || {
    failures=$((failures + 1))
    echo "FAILED: expected the message \"$1\" once in $2, found it $count times"
  }
}

testRefusals()
{
  step "Requests that several processes cannot meet, and a plugin for another VTK"
  draw 2 "Volume (Varimarch)" refused maximum shadows overlapping cropped_partition
  expectOnce "needs the whole ray" "$pictures/refused/log"
  expectOnce "scattering are on" "$pictures/refused/log"
  expectMessage "of the input overlap" "$pictures/refused/log"
  expectOnce "Cropping is on" "$pictures/refused/log"
  local other
  other=$(find build/*/lib/varimarch/plugins/vtk-9.1 -name varimarch.so 2>/dev/null | head -n 1)
  [ -n "$other" ] || { echo "Skipped: no plugin for VTK 9.1 in build; build the preset release"; return; }
  inParaView pvpython Testing/ParaView/load.py "$other" >"$pictures/other.log" 2>&1 || failures=$((failures + 1))
  expectMessage "Not a ParaView Plugin" "$pictures/other.log"
  expectMessage "drawn" "$pictures/other.log"
  VTK_AUTOLOAD_PATH=$(dirname "$other") inParaView pvpython Testing/ParaView/load.py none.so \
    >"$pictures/autoload.log" 2>&1 || failures=$((failures + 1))
  expectMessage "which this program does not use" "$pictures/autoload.log"
  expectMessage "drawn" "$pictures/autoload.log"
}

testPackage()
{
  step "The package"
  (cd build/paraview && cpack -G DEB >cpack.log) || fail "cpack failed; see build/paraview/cpack.log"
  dpkg-deb --contents build/paraview/packages/*.deb >"$pictures/package.log"
  expectMessage "./usr/lib/x86_64-linux-gnu/paraview-5.11/plugins/VarimarchVolume/VarimarchVolume.so" \
    "$pictures/package.log"
}

# The server listens on all networks and asks nobody who they are, so it gets a network of its own.
testServer()
{
  step "A server of two processes"
  mkdir -p "$pictures/server"
  inParaView unshare --net --map-root-user bash -c '
    ip link set lo up
    mpiexec --oversubscribe -n 2 pvserver --force-offscreen-rendering --server-port=21111 &
    server=$!
    sleep 20
    pvpython Testing/ParaView/draw.py "$1" "Volume (Varimarch)" "$2" 127.0.0.1:21111 composite
    kill $server 2>/dev/null || true
    wait $server || true' bash "$plugin" "$pictures/server" >"$pictures/server/log" 2>&1 || true
  row ""
  row "A server of two processes, against one:" \
    "$(compare "$pictures/ours-1/composite.png" "$pictures/server/composite.png" "$leastDecibels")"
}

setUp g++ cmake ninja-build ccache libglm-dev libtbb-dev libegl-dev libgl-dev libglx-dev \
  libopengl-dev libglew-dev libopenmpi-dev openmpi-bin libpython3-dev python3-dev libx11-dev \
  libxcursor-dev libdouble-conversion-dev libfreetype-dev libexpat1-dev liblzma-dev liblz4-dev \
  libjpeg-dev libtiff-dev iproute2 xvfb xauth python3-numpy python3-pil libgl1-mesa-dri libegl1
unpackParaView
step "Building the plugin"
buildPlugin
mkdir -p "$pictures"
: >"$report"
testOneProcess
testProgram
testOneInFloats
testReferences
testSeveralProcesses
testOrder
testSteps
testTimes
testRefusals
testDeath
testServer
testPackage
failures=$((failures + $(grep -oF '(FAILED)' "$report" | wc -l || true)))
[ "$failures" -eq 0 ] || fail "$failures checks failed; the pictures and logs are in $pictures"
