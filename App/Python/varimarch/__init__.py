"""Volume pictures that keep an error which you choose, with or without a display.

From an array or a file to a picture, an array again:

    import numpy, varimarch

    picture = varimarch.render(numpy.random.rand(64, 64, 64))       # [row, column, red green blue]
    picture = varimarch.render(varimarch.read("head.nii.gz"), preset="mr-head", view="left")
    varimarch.write_png(picture, "head.png")

render() draws; read() opens any volume file; to_image() and to_array() turn arrays into
vtkImageData and back; capture() takes the picture of a window; presets() lists the presets.

With VTK pipelines of your own use the classes, as every other class of VTK:
vtkVariationFieldVolumeMapper draws, vtkVolumeFileReader reads, vtkHeadlessRenderWindow is a window
that needs no display. C++ users have the same classes; their headers describe them.
"""

# The window's and the renderer's implementation, without which VTK would draw nothing.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from .VarimarchVolume import *  # noqa: F401,F403
from .images import read, to_array, to_image
from .looks import presets
from .pictures import capture, render, write_png
