"""Volume rendering within an error tolerance, with or without a display.

Images are rendered from arrays or files, and are arrays themselves:

    import numpy, varimarch

    image = varimarch.render(numpy.random.rand(64, 64, 64))         # [row, column, red green blue]
    image = varimarch.render(varimarch.read("head.nii.gz"), preset="mr-head", view="left")
    varimarch.write_png(image, "head.png")

render() renders a volume; read() opens any volume file, and times() lists its times; to_image() and
to_array() convert arrays to vtkImageData and back; capture() returns the image in a window; presets()
lists the presets; variation_field() returns how far values stay about the same around each voxel.
Viewer opens a volume in the program varimarch-viewer, and exchanges looks with it.

enable() lets PyVista, vedo, mayavi and other programs that leave the choice of a mapper to VTK draw
with Varimarch in this process.

In VTK pipelines of your own, use the classes like all other classes of VTK:
vtkVariationFieldVolumeMapper renders, vtkVolumeFileReader reads, vtkHeadlessRenderWindow is a window
that needs no display. The classes are the same as in C++, and their headers describe them.
"""

# This module implements windows and renderers, without which VTK draws nothing.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from . import VarimarchVolume
from ._scene import version as __version__
from .VarimarchVolume import *  # noqa: F401,F403
from .fields import variation_field
from .images import read, times, to_array, to_image
from .looks import presets
from .pictures import capture, render, write_png
from .plugin import enable
from .viewer import Viewer

__all__ = ["Viewer", "capture", "enable", "presets", "read", "render", "times", "to_array"]
__all__ += ["to_image", "variation_field", "write_png"]
__all__ += [name for name in dir(VarimarchVolume) if name.startswith("vtk")]


def __dir__():
    return [*__all__, "__doc__", "__version__"]
