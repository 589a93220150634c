"""A script that uses only VTK: renders a wavelet and prints the mapper class that VTK's factory made.

Usage: draw.py PICTURE.ppm [CLASS...]   CLASS: an override to disable first
"""

import sys

import vtkmodules.vtkRenderingOpenGL2
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkCommonCore import vtkObjectFactory
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNMWriter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

for name in sys.argv[2:]:
    vtkObjectFactory.SetAllEnableFlags(False, "vtkGPUVolumeRayCastMapper", name)

wavelet = vtkRTAnalyticSource()
wavelet.SetWholeExtent(-16, 16, -16, 16, -16, 16)

mapper = vtkGPUVolumeRayCastMapper()
mapper.SetInputConnection(wavelet.GetOutputPort())
mapper.AutoAdjustSampleDistancesOff()
mapper.SetSampleDistance(0.05)
print(mapper.GetClassName())

color = vtkColorTransferFunction()
color.AddRGBPoint(30.0, 0.1, 0.2, 0.9)
color.AddRGBPoint(280.0, 1.0, 0.7, 0.3)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(100.0, 0.0)
opacity.AddPoint(280.0, 0.3)
look = vtkVolumeProperty()
look.SetColor(color)
look.SetScalarOpacity(opacity)
look.SetInterpolationTypeToLinear()

volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(look)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(96, 96)
window.AddRenderer(renderer)
window.Render()

grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNMWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
