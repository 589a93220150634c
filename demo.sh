#!/usr/bin/env bash
# Installs missing packages (Debian 12), builds, and draws two real heads with our mapper and with
# VTK's mappers. Writes images, their differences, times and errors to demo-output/. With a display,
# it then builds and opens the viewer.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
. Testing/Support/set-up.sh

programs=build/release/bin
output=$PWD/demo-output

# compareMappers NAME VOLUME PRESET compares the mappers, unless a comparison exists that is newer
# than the program and the library.
compareMappers()
{
  if [ "$output/$1/compare.md" -nt "$programs/varimarch" ] &&
    [ "$output/$1/compare.md" -nt build/release/lib/libVarimarchVolume.so ]
  then
    step "The comparison on $1 is up to date"
    cat "$output/$1/compare.md"
    return
  fi
  step "Comparing the mappers on $1 (about a minute)"
  mkdir -p "$output/$1"
  "$programs/varimarch" compare "$2" -o "$output/$1" --preset "$3" --size 512x512 ||
    fail "The comparison on $2 failed; the reason is above."
}

setUp "${packages[@]}"
headCt=$(headCt)
build release varimarch 6

compareMappers head-ct "$headCt" ct-bone
compareMappers head-t1 /usr/share/mricron/templates/ch2better.nii.gz mr-head

step "Done: the images and tables are in $output"
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]
then
  build release varimarch-viewer 2
  step "Opening the viewer"
  "$programs/varimarch-viewer" "$headCt"
fi
