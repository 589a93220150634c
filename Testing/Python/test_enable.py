#!/usr/bin/env python3
"""Draws with classes of VTK alone, before and after varimarch.enable(), without a display.

Usage: test_enable.py CASE
"""

import pathlib
import sys

import numpy
import varimarch
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

OURS = "vtkVariationFieldGPUVolumeRayCastMapper"
VTKS = "vtkOpenGLGPUVolumeRayCastMapper"


def picture_of(mapper):
    """An image of a wavelet, which the mapper draws at a twentieth of a voxel."""
    wavelet = vtkRTAnalyticSource()
    mapper.SetInputConnection(wavelet.GetOutputPort())
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(0.05)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    look = volume.GetProperty()
    look.SetInterpolationTypeToLinear()
    look.GetRGBTransferFunction().AddRGBPoint(30, 0.1, 0.2, 0.9)
    look.GetRGBTransferFunction().AddRGBPoint(280, 1.0, 0.7, 0.3)
    look.GetScalarOpacity().AddPoint(100, 0.0)
    look.GetScalarOpacity().AddPoint(280, 0.3)
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = varimarch.vtkHeadlessRenderWindow()
    window.SetSize(96, 96)
    window.AddRenderer(renderer)
    window.Render()
    return varimarch.capture(window).astype(int)


def vtks_classes_draw_with_it():
    """The mappers differ by rounding, and by VTK's tables and first samples."""
    vtks = vtkGPUVolumeRayCastMapper()
    assert vtks.GetClassName() == VTKS, vtks.GetClassName()
    truth = picture_of(vtks)
    varimarch.enable()
    ours = vtkGPUVolumeRayCastMapper()
    assert ours.GetClassName() == OURS, ours.GetClassName()
    picture = picture_of(ours)
    assert ours.GetReasonForVtkMapper() == "", ours.GetReasonForVtkMapper()
    assert truth.max() > 50 and 0 < numpy.abs(picture - truth).max() <= 2
    # A smart mapper makes its mapper by itself.
    assert numpy.abs(picture_of(vtkSmartVolumeMapper()) - picture).max() <= 2


def it_is_switched_off_and_on():
    for enabled in (True, False, False, True, True):
        varimarch.enable(enabled)
        made = vtkGPUVolumeRayCastMapper().GetClassName()
        assert made == (OURS if enabled else VTKS), (enabled, made)


def a_missing_plugin_is_one_sentence():
    varimarch.plugin.LIBRARY = pathlib.Path("/not/installed/varimarch.so")
    try:
        varimarch.enable()
        raise AssertionError("a missing plugin was loaded")
    except OSError as error:
        assert "/not/installed/varimarch.so" in str(error), error
    assert vtkGPUVolumeRayCastMapper().GetClassName() == VTKS


if __name__ == "__main__":
    globals()[sys.argv[1]]()
