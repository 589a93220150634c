#!/usr/bin/env bash
# Runs VTK's own volume tests with VTK's mapper and then through our plugin, and compares the
# images.
#
# Usage: Testing/VtkSuite/run.sh BUILD_FOLDER [TEST...]
#   BUILD_FOLDER  a build of this tree, such as build/release; the suite writes to vtk-suite in it
#   TEST          names of tests; default: all
# Documentation/Reports/VtkTests.md holds the results.
#
# The tests come from the source package of the installed VTK (apt-get source, with a separate
# package list, which leaves the system's settings alone). Needs dpkg-dev, xvfb, python3-vtk9.
set -euo pipefail

suite=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
shift
work=$build/vtk-suite
mkdir -p "$work"

for program in apt-get dpkg-source xvfb-run
do
  command -v "$program" >/dev/null || { echo "$0: $program is missing" >&2; exit 1; }
done

# fetchSource FOLDER: unpacks the source package into the folder.
fetchSource()
{
  local apt=$work/apt
  mkdir -p "$apt/sources" "$apt/lists/partial" "$apt/cache/archives/partial"
  # The machine's package sources, switched to source packages.
  sed 's/^Types:.*/Types: deb-src/' /etc/apt/sources.list.d/debian.sources >"$apt/sources/vtk.sources" 2>/dev/null ||
    rm -f "$apt/sources/vtk.sources"
  sed -n 's/^deb\s/deb-src /p' /etc/apt/sources.list >"$apt/sources/vtk.list" 2>/dev/null || true
  local options=(
    -o "Dir::Etc::SourceList=/dev/null" -o "Dir::Etc::SourceParts=$apt/sources"
    -o "Dir::State::Lists=$apt/lists" -o "Dir::Cache=$apt/cache" -o "APT::Sandbox::User=$(id -un)"
  )
  local version
  version=$(dpkg-query --show --showformat '${source:Version}' libvtk9-dev)
  apt-get "${options[@]}" -qq update
  (cd "$apt" && apt-get "${options[@]}" -qq --download-only source "vtk9=$version")
  rm -rf "$1"
  dpkg-source --no-check --extract "$apt"/vtk9_*.dsc "$1.partial" >"$apt/unpack.log"
  mv "$1.partial" "$1"
}

[ -d "$work/source" ] || fetchSource "$work/source"
cmake -S "$suite" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVTK_SOURCE="$work/source" \
  -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache)" -DCMAKE_C_COMPILER_LAUNCHER="$(command -v ccache)" \
  >"$work/configure.log"
cmake --build "$work/build" --parallel 2 >"$work/build.log" || { tail "$work/build.log"; exit 1; }

# Without -noreset, the server forgets window settings when a test closes its only window.
exec xvfb-run --auto-servernum --server-args "-screen 0 1600x1200x24 -noreset" \
  /usr/bin/python3 "$suite/run_suite.py" "$build" "$@"
