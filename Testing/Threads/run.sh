#!/usr/bin/env bash
# run.sh [FILTER]: looks for data races. Builds TBB, from Debian's source package, and Core, the
# library, the viewer and their tests with ThreadSanitizer, and runs the tests that FILTER of
# GoogleTest selects, or all of them. Races between threads of TBB would be reported everywhere with
# Debian's own TBB, whose locks the sanitizer does not see. Reports are in build/tsan/races.*;
# suppressions.txt has those of libraries, with reasons.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

tbb=$PWD/build/tsan-tbb

# sourceOf PACKAGE FOLDER unpacks the source of an installed package. The settings of apt are those of
# the system, but for sources instead of programs, and stay in FOLDER.
sourceOf()
{
  local list folder=$2 name version
  mkdir -p "$folder/sources" "$folder/lists/partial"
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources
  do
    [ ! -e "$list" ] ||
      sed -E 's/^Types:.*/Types: deb-src/; s/^deb /deb-src /' "$list" >"$folder/sources/$(basename "$list")"
  done
  # shellcheck disable=SC2016 # dpkg-query replaces these
  read -r name version < <(dpkg-query --show --showformat '${source:Package} ${source:Version}\n' "$1")
  local settings=(-o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$folder/sources"
    -o Dir::State::Lists="$folder/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=
    -o APT::Sandbox::User=root)
  step "Fetching the source of $name $version"
  {
    LC_ALL=C apt-get --quiet "${settings[@]}" update || true
    cd "$folder"
    LC_ALL=C apt-get --quiet "${settings[@]}" --download-only source "$name=$version"
    dpkg-source --extract "$name"_*.dsc source
  } >"$packageLog" 2>&1 || failAsApt
}

buildTbb()
{
  [ ! -e "$tbb/installed/lib/cmake/TBB" ] || return 0
  (sourceOf libtbb-dev "$tbb")
  step "Building TBB with ThreadSanitizer (first time: about 2 minutes on 2 free cores)"
  if ! {
    cmake -S "$tbb/source" -B "$tbb/build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DCMAKE_INSTALL_PREFIX="$tbb/installed" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_CXX_FLAGS=-w \
      -DTBB_SANITIZE=thread -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF &&
      cmake --build "$tbb/build" --target install
  } >"$tbb/build.log" 2>&1
  then
    fail "TBB could not be built (see $tbb/build.log)."
  fi
}

setUp "${packages[@]}" "${testPackages[@]}" dpkg-dev
buildTbb
targets=(UnitTests TestProcessorMarching TestVoxelsOnDisk ViewerTests ViewerWindowTests)
for target in "${targets[@]}"
do
  build tsan "$target" 8
done

rm -f build/tsan/races.*
export TSAN_OPTIONS="suppressions=$PWD/Testing/Threads/suppressions.txt log_path=$PWD/build/tsan/races \
ignore_noninstrumented_modules=1 second_deadlock_stack=1"
# The libraries of VTK take the same TBB.
export LD_LIBRARY_PATH=$tbb/installed/lib
result=0
for target in "${targets[@]}"
do
  step "Running $target"
  display=()
  [ "$target" != ViewerWindowTests ] ||
    display=(env QT_QPA_PLATFORM=xcb xvfb-run --auto-servernum --server-args "-screen 0 1280x800x24 -noreset")
  "${display[@]}" "build/tsan/bin/$target" --gtest_brief=1 --gtest_filter="${1:-*}" || result=1
done
races=$(cat build/tsan/races.* 2>/dev/null | grep -c 'WARNING: ThreadSanitizer' || true)
[ "$races" -eq 0 ] || fail "ThreadSanitizer reports $races races; see build/tsan/races.*"
exit $result
