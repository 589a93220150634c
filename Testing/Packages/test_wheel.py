#!/usr/bin/env python3
"""Makes a wheel, installs it into a new virtual environment, draws there, and removes it.

Usage: test_wheel.py PREFIX
PREFIX: an install tree; its program draws the images to compare with
Needs Debian's python3-wheel and python3-venv, no network and no display.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

MAKE_WHEEL = pathlib.Path(__file__).resolve().parents[2] / "App/Packages/make_wheel.py"
LOOK = ["--preset=ct-bone", "--size=64x48"]

# Runs in the environment, where only the wheel can bring the package.
DRAW = """
import numpy, re, sys, varimarch
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

z, y, x = numpy.mgrid[-1:1:24j, -1:1:24j, -1:1:24j]
writer = vtkXMLImageDataWriter()
writer.SetFileName("ball.vti")
writer.SetInputData(varimarch.to_image((500 - 400 * numpy.hypot(x, y + z)).astype("int16")))
writer.Write()
picture = varimarch.render(varimarch.read("ball.vti"), preset="ct-bone", size=(64, 48))
varimarch.write_png(picture, "wheel.png")

varimarch.enable()
assert vtkGPUVolumeRayCastMapper().IsA("vtkVariationFieldGPUVolumeRayCastMapper")
loaded = set(re.findall(r"\\S*/[^/ ]*[vV]arimarch\\S*", open("/proc/self/maps").read()))
assert len(loaded) >= 4 and all(path.startswith(sys.prefix) for path in loaded), loaded
"""


def run(*command, folder):
    """Runs a command without any variable that tells where Varimarch is."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "LD_LIBRARY_PATH", "VTK_AUTOLOAD_PATH", "DISPLAY")
        and not name.startswith("VARIMARCH_")
    }
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


def pixels_of_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def files_of_ours(folder):
    """The files below a folder whose paths contain our name."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return [path for path in files if "varimarch" in str(path.relative_to(folder)).lower()]


def test_wheel(prefix, folder):
    wheel = run(sys.executable, MAKE_WHEEL, prefix, folder, folder=folder).strip()
    environment = folder / "environment"
    python = environment / "bin" / "python"
    run(sys.executable, "-m", "venv", "--system-site-packages", environment, folder=folder)
    pip = (python, "-m", "pip", "--disable-pip-version-check")
    run(*pip, "install", "--no-index", wheel, folder=folder)

    run(python, "-c", DRAW, folder=folder)
    for program in (prefix, environment):
        picture = f"{program.name}.png"
        run(program / "bin" / "varimarch", "render", "ball.vti", "-o", picture, *LOOK, folder=folder)
        expected, drawn = (pixels_of_png(folder / name) for name in (picture, "wheel.png"))
        assert len(numpy.unique(drawn)) > 20, "nothing is drawn"
        assert numpy.array_equal(drawn, expected), f"the image of {program}/bin/varimarch differs"

    run(*pip, "uninstall", "--yes", "varimarch", folder=folder)
    assert files_of_ours(environment) == [], files_of_ours(environment)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test_wheel(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(name).resolve())
