#!/usr/bin/env bash
# Builds Core and its unit tests for 64 bit ARM and for x86 without AVX2, and runs the tests on
# emulated processors. It needs the packages below, from Debian 12, and the network for TBB's arm64
# packages. Those are unpacked in the build folder, so nothing of another architecture is installed.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

build=$PWD/build/cross
foreign=$build/arm64

# Runs apt-get for arm64 with settings and data of its own, which leaves the system unchanged.
foreignApt()
{
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$foreign/state" \
    -o Dir::State::status=/dev/null -o Dir::Cache="$foreign/cache" -o APT::Sandbox::User=root "$@"
}

unpackTbb()
{
  [ -e "$foreign/usr/include/tbb" ] && return
  mkdir -p "$foreign/state/lists/partial" "$foreign/cache/archives/partial"
  foreignApt update
  (cd "$foreign/cache" && foreignApt download libtbb12 libtbb-dev libtbbmalloc2 libtbbbind-2-5)
  local package
  for package in "$foreign"/cache/*.deb
  do
    dpkg-deb --extract "$package" "$foreign"
  done
}

# runOn NAME EMULATOR OPTION... builds with CMake's options, and runs the tests with the emulator's
# command line.
runOn()
{
  local name=$1 emulator=$2
  shift 2
  step "Building for $name"
  cmake -S Testing/Cross -B "$build/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
  cmake --build "$build/$name" --target UnitTests
  step "Testing on $name"
  $emulator "$build/$name/Unit/UnitTests" --gtest_brief=1
}

setUp g++ cmake ninja-build ccache libglm-dev libtbb-dev \
  g++-aarch64-linux-gnu qemu-user googletest
unpackTbb
runOn aarch64 "qemu-aarch64 -L /usr/aarch64-linux-gnu" \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/Testing/Cross/aarch64.cmake" \
  -DTBB_DIR="$foreign/usr/lib/aarch64-linux-gnu/cmake/TBB"
# Nehalem is a processor of 2008. The program also contains the code for AVX2, which must not be
# called.
runOn x86-64 "qemu-x86_64 -cpu Nehalem"
