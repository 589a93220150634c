#!/usr/bin/env bash
# compile.sh [FOLDER...]
#
# Compiles every file of the module, and of the libraries that it consists of, against the headers of
# other versions of VTK, and prints a row for each. Nothing is linked. A FOLDER is one of
#   - a folder with all headers of VTK, such as /usr/include/vtk-9.1
#   - a folder in which VTK was configured; it need not be built. This takes few minutes:
#       cmake -S VTK -B VTK-build -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT \
#         -DVTK_GROUP_ENABLE_Rendering=DONT_WANT -DVTK_MODULE_ENABLE_VTK_RenderingVolumeOpenGL2=YES \
#         -DVTK_MODULE_ENABLE_VTK_IOXML=YES -DVTK_MODULE_ENABLE_VTK_IOImage=YES
# Without a FOLDER, it takes the VTK of Debian 12 and the one inside Debian 12's ParaView, from
# packages. The exit code is 1 if a file does not compile. The varimarch-decode program is a process
# of its own, which needs vtk-dicom and therefore Debian's VTK; it is not compiled.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
. Testing/Support/set-up.sh

batchSize=${BATCH_SIZE:-8}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# filesIn FOLDER LIST prints the sources that a list in the CMakeLists.txt of a folder names, from a
# line that begins with LIST to the closing parenthesis.
filesIn()
{
  sed -n "/^$2/,/)/p" "$1/CMakeLists.txt" | grep -oE '[A-Za-z0-9/]+\.cxx' | sed "s|^|$PWD/$1/|"
}

# Prints the module's sources in the order of its unity build.
listFiles()
{
  sed -n '/^set(classes/,/)/s/^ *\(vtk[A-Za-z0-9]*\))\?$/\1/p' VolumeModule/CMakeLists.txt |
    sed "s|.*|$PWD/VolumeModule/&.cxx|"
  echo "$PWD/VolumeModule/vtkVolumeFileReader.cxx"
  filesIn VolumeModule 'set(sources'
  filesIn VolumeModule 'set(readers'
  echo "$PWD/VolumeModule/Plugin/Factory.cxx"
  filesIn VolumeModule/Readers 'add_library(VarimarchReaders'
}

# Writes what CMake generates in a build: the export macro, and files that include several others, as
# in the unity build.
writeBatches()
{
  mkdir "$work/batches"
  cat >"$work/VarimarchVolumeModule.h" <<'HEADER'
#define VARIMARCHVOLUME_EXPORT
#define VARIMARCHVOLUME_NO_EXPORT
HEADER
  # Empty names in place of those of a build.
  sed 's/@[a-z_]*@//' VolumeModule/Plugin/PluginNames.h.in >"$work/PluginNames.h"
  listFiles | sed 's/.*/#include "&"/' |
    split --lines="$batchSize" --additional-suffix=.cxx --numeric-suffixes - "$work/batches/"
}

# Prints folders that have the headers of a VTK which was configured in a folder: those of its
# modules' sources, and those that CMake has generated.
foldersOf()
{
  local build=$1 source=$2 module
  find "$build" -name 'vtk*Module.h' -printf '%h\n' | sort -u | while read -r module
  do
    printf '%s\n' "$module" "$source/${module#"$build"/}"
  done
  find "$source/ThirdParty" -mindepth 1 -maxdepth 1 -type d
  find "$build/ThirdParty" -mindepth 1 -maxdepth 1 -type d
  printf '%s\n' "$build/Utilities/KWSys" "$build/Utilities/KWIML" "$source/Utilities/KWIML"
}

# headersOf FOLDER prints the options by which the compiler finds the headers.
headersOf()
{
  local folder
  if [ -e "$1/CMakeCache.txt" ]
  then
    foldersOf "$1" "$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$1/CMakeCache.txt")"
  else
    echo "$1"
  fi | while read -r folder
  do
    [ ! -d "$folder" ] || printf -- '-isystem "%s"\n' "$folder"
  done
}

versionOf()
{
  echo '#include "vtkVersionMacros.h"
VTK_VERSION' | c++ -E -P -xc++ "@$1" - 2>/dev/null | tail -n 1 | tr -d '"'
}

# compile OPTIONS BATCH
compile()
{
  c++ -std=c++17 -fsyntax-only -Wall -Wextra -Wno-subobject-linkage -DVARIMARCH_VERSION='"0"' \
    -DVARIMARCH_DECODER_BESIDE_LIBRARY='"varimarch-decode"' "@$1" "$2" >"$2.log" 2>&1 ||
    touch "$2.failed"
}
export -f compile

# compileWith FOLDER prints the row of a version, and the errors if there are any.
compileWith()
{
  local folder options=$work/options files batches failed warnings
  folder=$(readlink -f "$1")
  { printf -- '-I"%s"\n' "$work" "$PWD/VolumeModule"; headersOf "$folder"; } >"$options"
  rm -f "$work"/batches/*.log "$work"/batches/*.failed
  find "$work/batches" -name '*.cxx' | sort |
    xargs -P "${JOBS:-$(nproc)}" -I '{}' bash -c 'compile "$0" "{}"' "$options"
  files=$(cat "$work"/batches/*.cxx | wc -l)
  batches=$(find "$work/batches" -name '*.cxx' | wc -l)
  failed=$(find "$work/batches" -name '*.failed' | wc -l)
  warnings=$(cat "$work"/batches/*.log | grep -c 'warning:' || true)
  echo "VTK $(versionOf "$options"): $files files in $batches batches," \
    "$failed batches failed, $warnings warnings"
  cat "$work"/batches/*.log | grep -E '(error|warning):' | sort -u | head -n 40
  [ "$failed" -eq 0 ]
}

if [ $# -eq 0 ]
then
  setUp g++ libvtk9-dev libglm-dev libtbb-dev zlib1g-dev libnifti-dev libglew-dev libegl-dev libgl-dev
  paraview=build/data/paraview-dev
  [ -e "$paraview" ] || unpackPackage paraview-dev "$paraview"
  set -- /usr/include/vtk-9.1 "$paraview/usr/include/paraview-5.11"
fi
writeBatches
status=0
for folder in "$@"
do
  compileWith "$folder" || status=1
done
exit "$status"
