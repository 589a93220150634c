#!/usr/bin/env python3
"""Draws with classes of VTK alone, before and after varimarch.enable(), without a display.

Usage: test_enable.py CASE
"""

import os
import pathlib
import subprocess
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


def tolerance_in_a_process_with(text):
    """The default error tolerance in a process with this VARIMARCH_ERROR_TOLERANCE, and its messages."""
    script = f"import varimarch; print(varimarch.{OURS}.GetDefaultErrorTolerance())"
    environment = dict(os.environ, VARIMARCH_ERROR_TOLERANCE=text)
    ended = subprocess.run([sys.executable, "-c", script], env=environment, check=True,
                           capture_output=True, text=True)
    return float(ended.stdout), ended.stderr


def mappers_that_vtk_makes_keep_the_error_tolerance():
    varimarch.enable()
    assert vtkGPUVolumeRayCastMapper().GetVariationFieldMapper().GetErrorTolerance() == 1 / 64
    varimarch.enable(error_tolerance=1 / 255)
    assert vtkGPUVolumeRayCastMapper().GetVariationFieldMapper().GetErrorTolerance() == 1 / 255
    for wrong in (-0.1, 2, "small", float("nan")):
        try:
            varimarch.enable(error_tolerance=wrong)
            raise AssertionError(f"{wrong} was taken")
        except ValueError as error:
            assert "error_tolerance: expected a number from 0 to 1" in str(error), error
    assert tolerance_in_a_process_with("0.125") == (0.125, "")
    for wrong in ("", "2", "1/64", "-1", "nan"):
        tolerance, messages = tolerance_in_a_process_with(wrong)
        assert tolerance == 1 / 64
        assert f'VARIMARCH_ERROR_TOLERANCE is "{wrong}": expected a number from 0 to 1' in messages


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
