#!/usr/bin/env bash
# Builds Core and its unit tests for 64 bit ARM, and for x86 without AVX2, and runs the tests on
# emulated processors. It needs the packages below, of Debian 12, and the network for TBB's arm64
# packages, which are unpacked in the build folder: nothing of another architecture is installed.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

build=$PWD/build/cross
foreign=$build/arm64

# An apt of its own, which knows arm64 and changes nothing of the system's.
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

# @param $1  name of the build
# @param $2  processor, as qemu-user calls it
# The other parameters are CMake's.
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
# A processor of 2008. The program holds the copy for AVX2 too, of which nothing may be called.
runOn x86-64 "qemu-x86_64 -cpu Nehalem"
