# What smoke-test.sh runs in the new system.
set -eu
cd /smoke
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
install()
{
  printf '\n== Installing %s\n' "$*"
  apt-get --quiet=2 --assume-yes install "$@" >apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
}
drawn()
{
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] || { echo "$1 is no picture"; exit 1; }
}

install ./libvarimarchvolume*.deb ./varimarch_*.deb
varimarch --version
varimarch render procedural:shells:32x32x32 -o procedural.png --size 64x64
varimarch render /usr/share/varimarch/Scenes/shells-step.json -o scene.png --size 64x64
drawn procedural.png
# The decoder reads this format.
varimarch convert procedural:shells:8x8x8 shells.vti
varimarch info shells.vti
drawn scene.png
ls /usr/share/man/man1/varimarch.1.gz /usr/share/man/man1/varimarch-render.1.gz

install ./python3-varimarch_*.deb
python3 Examples/Python/array_to_picture.py array.png
python3 Examples/Python/vtk_pipeline.py pipeline.png
drawn array.png
drawn pipeline.png
# A script that knows VTK only, by the plugin.
VTK_AUTOLOAD_PATH=$(dirname /usr/lib/*/varimarch/plugins/*/varimarch.so) python3 -c '
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
name = vtkGPUVolumeRayCastMapper().GetClassName()
assert name == "vtkVariationFieldGPUVolumeRayCastMapper", name
print("the plugin makes a", name)'

install ./varimarch-viewer_*.deb
QT_QPA_PLATFORM=offscreen varimarch-viewer --version
ls /usr/share/applications/varimarch-viewer.desktop

install ./libvarimarch-dev_*.deb g++ make cmake
cmake -S Examples/Headless -B headless >cmake.log 2>&1 || { cat cmake.log; exit 1; }
cmake --build headless
printf 'NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n0 0 0 0 0 255 255 255\n' >cube.nrrd
headless/headless cube.nrrd headless.png
drawn headless.png

apt-get --quiet=2 --assume-yes purge 'libvarimarch*' 'varimarch*' python3-varimarch >apt.log 2>&1
left=$(find /usr /etc /var/lib -xdev -iname '*varimarch*')
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
