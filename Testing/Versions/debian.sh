#!/usr/bin/env bash
# debian.sh SUITE [CTEST_ARGUMENT...]
#
# Builds the mapper, the plugin and their tests with the VTK of another release of Debian, and runs
# them: "trixie" has VTK 9.3, "sid" has 9.6 in 2026. The release is installed by debootstrap in the
# folder build/debian-SUITE, or in that of the environment variable VARIMARCH_DEBIAN, with 3 GB of
# packages, which takes about 10 minutes. Needs root, because it changes into that folder. What run.sh
# builds is in build/vtk-VERSION. The exit code is not 0 if anything fails.
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | grep -v '^set'; exit 2; }
suite=$1
shift
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

setUp debootstrap
root=${VARIMARCH_DEBIAN:-$PWD/build/debian-$suite}
step "Debian $suite in $root"
# debootstrap removes its own folder when it is done.
if [ ! -e "$root/usr/bin/apt-get" ] || [ -e "$root/debootstrap" ]
then
  requireFreeMegabytes 5000 "$(dirname "$root")" "Debian $suite"
  asRoot debootstrap --variant=minbase "$suite" "$root" http://deb.debian.org/debian \
    >"build/debian-$suite.log" 2>&1 ||
    fail "debootstrap could not install Debian $suite: $(tail -n 1 "build/debian-$suite.log")"
fi

# The folders of the system and this tree are seen in the release until the command ends.
asRoot mkdir -p "$root/varimarch"
# shellcheck disable=SC2016
asRoot unshare --mount bash -c '
  set -euo pipefail
  root=$1
  shift
  mount --bind "$PWD" "$root/varimarch"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  cp --remove-destination /etc/resolv.conf "$root/etc/resolv.conf"
  exec chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive bash -c "
      set -euo pipefail
      cd /varimarch
      apt-get -qq -o Acquire::Check-Valid-Until=false update
      apt-get -qq install --no-install-recommends libvtk9-dev python3-vtk9 >/var/log/varimarch.log 2>&1 ||
        { tail -n 3 /var/log/varimarch.log; exit 1; }
      Testing/Versions/run.sh /usr \"\$@\"" bash "$@"' bash "$root" "$@"
