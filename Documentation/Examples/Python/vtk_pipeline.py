"""A pipeline of VTK's own classes with our mapper in it, and a surface inside the volume.

Usage: vtk_pipeline.py PICTURE.png
"""
import sys

import varimarch
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkVolume,
)

wavelet = vtkRTAnalyticSource()

# Where vtkGPUVolumeRayCastMapper or vtkSmartVolumeMapper stood.
mapper = varimarch.vtkVariationFieldVolumeMapper()
mapper.SetInputConnection(wavelet.GetOutputPort())
mapper.SetErrorTolerance(1 / 255)

colors = vtkColorTransferFunction()
colors.AddRGBPoint(40, 0.1, 0.3, 0.9)
colors.AddRGBPoint(277, 1.0, 0.9, 0.6)
opacities = vtkPiecewiseFunction()
opacities.AddPoint(120, 0.0)
opacities.AddPoint(277, 0.4)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetColor(colors)
volume.GetProperty().SetScalarOpacity(opacities)

sphere = vtkSphereSource()
sphere.SetRadius(4)
surface = vtkActor()
surface.SetMapper(vtkPolyDataMapper())
surface.GetMapper().SetInputConnection(sphere.GetOutputPort())

renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.AddActor(surface)
window = varimarch.vtkHeadlessRenderWindow()  # with a display, vtkRenderWindow does as well
window.SetSize(400, 400)
window.AddRenderer(renderer)
window.Render()

varimarch.write_png(varimarch.capture(window), sys.argv[1])
print(f"{mapper.GetUsedSampleDistance():.3g} mm between samples,", window.GetDeviceName())
