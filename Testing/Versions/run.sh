#!/usr/bin/env bash
# run.sh VTK_FOLDER [CTEST_ARGUMENT...]
#
# Builds the mapper, the plugin and their tests with a VTK, and runs them. VTK_FOLDER is one in which
# VTK was built, or a prefix in which it is installed; it needs the modules that the head of compile.sh
# names, and FiltersSources. The files are in build/vtk-VERSION. The exit code is not 0 if anything fails.
# The readers and the programs need libraries that are built for Debian's VTK, and are left out.
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | grep -v '^set'; exit 2; }
vtk=$(readlink -f "$1")
shift
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

setUp g++ cmake ninja-build ccache libglm-dev libtbb-dev libegl-dev libgl-dev libgtest-dev python3 \
  libegl1 libgl1-mesa-dri xvfb xauth
[ -d "$vtk" ] || fail "$vtk is no folder: expected one with a VTK"
config=$(find "$vtk" -path '*/cmake/*' -name vtk-config.cmake -printf '%h\n' -quit)
[ -n "$config" ] || fail "no VTK is in $vtk: expected a file cmake/*/vtk-config.cmake in it, found none"
version=$(sed -n 's/^set(PACKAGE_VERSION "\(.*\)")/\1/p' "$config/vtk-config-version.cmake")
build=build/vtk-$version
step "VTK $version: building in $build"
cmake -S . -B "$build" -G Ninja -DVARIMARCH_MAPPER_ALONE=ON -DVTK_DIR="$config" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 >"$build.log" 2>&1 ||
  fail "CMake could not configure the mapper; see $build.log"
cmake --build "$build"
step "VTK $version: tests"
ctest --test-dir "$build" --output-on-failure "$@"
