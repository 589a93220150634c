# shellcheck shell=bash
# Functions for demo.sh, test.sh and .ci/run that install missing packages, build, and find the head
# CT. The file is sourced in the top folder of the tree. A failure prints one sentence that says what
# is missing.

packages=(
  # To build
  g++ cmake ninja-build ccache pkg-config git python3
  libvtk9-dev libvtk-dicom-dev libgdcm-dev libglm-dev libtbb-dev nlohmann-json3-dev libcli11-dev
  zlib1g-dev libplist-dev libarchive-dev libtiff-dev libhdf5-dev libnetcdf-dev
  libblosc-dev liblz4-dev
  libegl-dev libgl-dev libglew-dev
  python3-dev python3-numpy python3-vtk9 vtk9
  qtbase5-dev qttools5-dev qttools5-dev-tools qttranslations5-l10n libqt5svg5-dev libqt5sql5-sqlite libvtk9-qt-dev
  libinsighttoolkit5-dev libdcmtk-dev
  # To draw without a graphics card
  libegl1 libgl1-mesa-dri
  # Real volumes: a head CT and a T1 head
  invesalius-examples mricron-data
)
testPackages=(
  at-spi2-core dbus dcmtk dicom3tools libgtest-dev glslang-tools openbox openssl orthanc orthanc-dicomweb
  python3-fuse python3-h5py python3-pyatspi python3-pydicom python3-vedo python3-venv python3-wheel
  python3-zarr xdotool xvfb xauth
  # Other programs that read volumes, to compare with
  dcm2niix mrtrix3 python3-mrcfile python3-nibabel python3-tifffile teem-apps
)
fuzzPackages=(clang libclang-rt-14-dev)
packageLog=build/packages.log

step()
{
  printf '\n== %s\n' "$*"
}

fail()
{
  printf '\n%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# missingPackages PACKAGE... prints the packages that are not installed.
missingPackages()
{
  local installed
  installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  local package
  for package in "$@"
  do
    grep -qxF "installed $package" <<<"$installed" || echo "$package"
  done
}

requireFreeMegabytes()
{
  local free
  free=$(df --output=avail -BM "$2" | tail -n 1 | tr -dc 0-9)
  [ "$free" -ge "$1" ] || fail "$3 needs $1 MB of free disk space in $2, but only $free MB are free."
}

asRoot()
{
  if [ "$(id -u)" -eq 0 ]
  then
    "$@"
  else
    sudo "$@"
  fi
}

requireRoot()
{
  [ "$(id -u)" -eq 0 ] && return
  command -v sudo >/dev/null ||
    fail "sudo is missing, and only root can install packages; as root, run: apt-get install $*"
  # sudo may ask for a password only at a terminal, where a user can answer.
  sudo -n true 2>/dev/null || [ -t 0 ] ||
    fail "sudo needs a password; once, at a terminal, run: sudo apt-get install $*"
}

# Exits with one sentence that gives the reason for apt's failure, from its log.
failAsApt()
{
  local error
  error=$(grep -E '^(E|dpkg): ' "$packageLog" | tail -n 1 || true)
  case "$error" in
    *"Unable to locate package"* | *"no installation candidate"*)
      # If the package lists could not be loaded, the cause is the network, otherwise the sources.
      grep -qE 'Failed to fetch|Could not resolve|Temporary failure' "$packageLog" ||
        fail "A package source is missing: apt says \"${error#E: }\"; Debian 12 (main) has it." ;&
    *[Ff]"etch "*)
      fail "The network is missing: apt could not download the packages (see $packageLog)." ;;
    *"No space left"* | *"enough free space"*)
      fail "Disk space is missing: apt could not store the packages (see $packageLog)." ;;
    *)
      fail "apt could not install the packages: ${error:-no reason given} (see $packageLog)" ;;
  esac
}

# Passes apt's output on, and replaces its status lines by a message for every ten percent.
showProgress()
{
  local line shown="" now
  while IFS= read -r line
  do
    case "$line" in
      dlstatus:*) now="downloading" ;;
      pmstatus:*) now="installing" ;;
      *) echo "$line"; continue ;;
    esac
    line=${line#*:*:}
    now="$now $((${line%%[.:]*} / 10 * 10)) %"
    [ "$now" = "$shown" ] || echo "   $now" >&2
    shown=$now
  done
}

aptGet()
{
  asRoot env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get --quiet --assume-yes \
    -o DPkg::Lock::Timeout=600 -o Dpkg::Options::=--force-confold "$@" </dev/null 2>&1
}

systemName()
{
  sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release 2>/dev/null || uname
}

installMissingPackages()
{
  command -v apt-get >/dev/null ||
    fail "apt is missing: packages can be installed only on Debian 12, but this system is $(systemName)."
  local missing
  mapfile -t missing < <(missingPackages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0

  step "Installing ${#missing[@]} packages and their dependencies (about 3 minutes for all): ${missing[*]}"
  requireRoot "${missing[@]}"
  requireFreeMegabytes 4000 /usr "Installing the packages"
  : >"$packageLog"
  # An installation that was interrupted is finished first.
  asRoot dpkg --configure -a </dev/null >>"$packageLog" 2>&1 || true
  # A failure is ignored, because the package source that cannot be reached may be unrelated.
  aptGet update >>"$packageLog" || true
  aptGet -o APT::Status-Fd=1 install --no-install-recommends "${missing[@]}" |
    showProgress >>"$packageLog" || failAsApt
}

# Prints the path of the head CT. It is installed as documentation, which slim systems leave out; it
# is then unpacked from its package.
headCt()
{
  local path=usr/share/doc/invesalius-examples/examples/Cranium.inv3
  local unpacked=build/data/invesalius-examples
  if [ ! -e "/$path" ] && [ ! -e "$unpacked/$path" ]
  then
    unpackPackage invesalius-examples "$unpacked"
  fi
  [ -e "/$path" ] && echo "/$path" || echo "$PWD/$unpacked/$path"
}

# unpackPackage NAME FOLDER downloads and unpacks a package, completely or not at all.
unpackPackage()
{
  local partial="$2.partial"
  rm -rf "$partial"
  mkdir -p "$partial"
  step "Unpacking the package $1, whose files this system leaves out" >&2
  aptGet update >"$packageLog" || true
  (cd "$partial" && LC_ALL=C apt-get --quiet download "$1") >>"$packageLog" 2>&1 || failAsApt
  dpkg-deb --extract "$partial/$1"_*.deb "$partial"
  rm "$partial/$1"_*.deb
  mv "$partial" "$2"
}

# setUp PACKAGE... makes the build folder and installs missing packages.
setUp()
{
  mkdir -p build 2>/dev/null || fail "$PWD cannot be written to; copy the tree to a folder of your own."
  installMissingPackages "$@"
}

# build PRESET TARGET MINUTES builds a target. MINUTES is the time of a first build on two free cores.
build()
{
  requireFreeMegabytes 1000 "$PWD" "Building"
  step "Building the target $2 in build/$1 (first time: about $3 minutes on 2 free cores)"
  cmake --preset "$1" >"build/$1.log" 2>&1 ||
    fail "CMake could not configure the build: $(grep -A 3 'CMake Error' "build/$1.log" | tr -s ' \n' ' ' | head -c 300) (see build/$1.log)"
  cmake --build --preset "$1" --target "$2" || fail "The build failed; the compiler's messages are above."
}
