#!/usr/bin/env python3
"""Spoils baselines by an RMSE of 2 of 255 and expects that the tests of these pictures fail.

Usage: test_spoilt_baselines.py REGRESSION_TESTS FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

RMSE = 2.0
NAMES = ["Composite", "Isosurfaces", "TranslucentGeometry"]


def noise(pixels):
    """Adds the same amount with random signs."""
    return pixels + RMSE * numpy.random.default_rng(1).choice([-1.0, 1.0], pixels.shape)


def brighter(pixels):
    """Adds it everywhere: no edge changes, so that VTK's measure sees nothing."""
    return numpy.where(pixels + RMSE <= 255, pixels + RMSE, pixels - RMSE)


def blot(pixels):
    """Inverts the lowest bits of a few pixels so far that the mean is as large."""
    spoilt = pixels.copy()
    count = len(pixels) // 100
    spoilt[:count] += numpy.where(spoilt[:count] < 128, 1, -1) * RMSE * (len(pixels) / count) ** 0.5
    return spoilt


def write_spoilt(baseline, spoil, path):
    reader = vtkPNGReader()
    reader.SetFileName(str(baseline))
    reader.Update()
    image = reader.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    spoilt = numpy.clip(numpy.round(spoil(pixels)), 0, 255)
    rmse = ((spoilt - pixels) ** 2).mean() ** 0.5
    assert abs(rmse - RMSE) < 0.1, f"{spoil.__name__} spoils {baseline} by {rmse}"
    image.GetPointData().SetScalars(numpy_to_vtk(spoilt.astype(numpy.uint8), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def main(program, folder):
    with tempfile.TemporaryDirectory() as temporary:
        spoilt_folder = pathlib.Path(temporary) / "spoilt"
        spoilt_folder.mkdir()
        for name in NAMES:
            for spoil in noise, brighter, blot:
                path = spoilt_folder / f"{name}.png"
                write_spoilt(pathlib.Path(folder) / "Baseline" / f"{name}.png", spoil, path)
                run = subprocess.run(
                    [program, name, "-D", folder, "-T", temporary, "-V", str(path)],
                    capture_output=True, text=True, check=False)
                found = run.returncode == 1 and "of 255, allowed are" in run.stderr
                assert found, f"{name}, {spoil.__name__}: {run.returncode}\n{run.stderr}"
                # VTK makes no image of a difference that its own measure does not see.
                for picture in "TestImage", "ValidImage":
                    assert f'name="{picture}"' in run.stdout, f"no {picture}\n{run.stdout}"


main(*sys.argv[1:])
