#!/usr/bin/env python3
"""Draws a volume with programs of Debian that know only VTK, without and with the plugin.

Usage: test_packages.py PACKAGE PLUGIN_FOLDER
PACKAGE: python3-vedo, mayavi2 or f3d; the exit code is 77 if it is not installed
Needs an X display and a Python with VTK.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageShiftScale, vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SCRIPTS = pathlib.Path(__file__).with_name("Packages")
COMMANDS = {
    "python3-vedo": (sys.executable, SCRIPTS / "vedo_volume.py", "VOLUME", "PICTURE"),
    "mayavi2": (sys.executable, SCRIPTS / "mayavi_volume.py", "VOLUME", "PICTURE"),
    "f3d": ("f3d", "--volume", "--resolution=200,200", "--output=PICTURE", "VOLUME"),
}
WE_DRAW = "Varimarch: The variation field mapper draws."
# These programs leave the sample distance to the mapper. VTK's then takes half a voxel, at which its
# error is of this size, as a root mean square [1/255].
TOLERATED = 2


def write_wavelet(path):
    """A wavelet in 8 bits, which all of the programs read."""
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-16, 16, -16, 16, -16, 16)
    bytes_of_it = vtkImageShiftScale()
    bytes_of_it.SetInputConnection(wavelet.GetOutputPort())
    bytes_of_it.SetShift(-30)
    bytes_of_it.SetOutputScalarTypeToUnsignedChar()
    writer = vtkXMLImageDataWriter()
    writer.SetInputConnection(bytes_of_it.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def pixels_of_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    width, height, _ = image.GetDimensions()
    return pixels.reshape(height, width, -1)[::-1, :, :3].astype(int)


def draw(package, folder, plugin):
    """The image of a program, and all it says."""
    names = {"VOLUME": str(folder / "wavelet.vti"), "PICTURE": str(folder / "picture.png")}
    command = [str(part) for part in COMMANDS[package]]
    for name, path in names.items():
        command = [part.replace(name, path) for part in command]
    environment = {**os.environ, "VARIMARCH_VERBOSE": "1", "HOME": str(folder)}
    environment["VTK_AUTOLOAD_PATH"] = plugin
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return pixels_of_png(names["PICTURE"]), done.stdout + done.stderr


def test_package(package, plugin, folder):
    write_wavelet(folder / "wavelet.vti")
    vtks, said = draw(package, folder, "")
    assert WE_DRAW not in said, said
    ours, said = draw(package, folder, plugin)
    assert WE_DRAW in said, said
    difference = ours - vtks
    rmse = numpy.sqrt((difference**2).mean())
    print(f"{package}: RMSE {rmse:.2f}, largest {abs(difference).max()} of 255")
    assert len(numpy.unique(ours)) > 50, "nothing is drawn"
    assert 0 < rmse <= TOLERATED


def is_installed(package):
    query = ["dpkg-query", "--show", "--showformat=${db:Status-Status}", package]
    return subprocess.run(query, capture_output=True, text=True, check=False).stdout == "installed"


if __name__ == "__main__":
    if not is_installed(sys.argv[1]):
        print(f"{sys.argv[1]} is not installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        test_package(*sys.argv[1:3], pathlib.Path(name))
