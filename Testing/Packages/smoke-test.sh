#!/usr/bin/env bash
# Installs the Debian packages on a Debian 12 that has nothing else, and uses each of them there.
# Usage, as root and with a network: smoke-test.sh FOLDER, which holds the packages. Takes minutes.
set -euo pipefail

packages=$(realpath "${1:?the folder with the packages, build/package/packages}")
tree=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
command -v mmdebstrap >/dev/null || { echo "mmdebstrap is missing: apt-get install mmdebstrap" >&2; exit 1; }

# Of the new system nothing is kept: it is a temporary folder of mmdebstrap.
env --unset=DISPLAY mmdebstrap --quiet --variant=apt \
  --customize-hook="mkdir \"\$1/smoke\"" \
  --customize-hook="cp '$packages'/*.deb '$tree/Testing/Packages/use-packages.sh' \"\$1/smoke\"" \
  --customize-hook="cp --recursive '$tree/Documentation/Examples' \"\$1/smoke\"" \
  --customize-hook="chroot \"\$1\" sh /smoke/use-packages.sh" \
  bookworm /dev/null
echo "The packages install, work, and are gone when removed."
