"""The volume mapper of Varimarch for the VTK of VTK's own wheels.

    import pyvista, varimarch

    varimarch.enable()              # PyVista and all that leaves the mapper to VTK draw with it

vtkVariationFieldVolumeMapper is the mapper for pipelines of your own, vtkHeadlessRenderWindow a window
that needs no display. The package for Debian's VTK has render() and read() too.
"""

# These modules bring VTK's libraries into the process, where ours find them.
import vtkmodules.vtkRenderingOpenGL2
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from . import VarimarchVolume
from .VarimarchVolume import *  # noqa: F401,F403
from .plugin import enable

__all__ = ["enable", *(name for name in dir(VarimarchVolume) if name.startswith("vtk"))]
