#!/usr/bin/env python3
"""Runs one of VTK's Python tests of its CPU mapper with the class that the factory makes instead.

Usage: python_matrix.py FOLDER_OF_SCRIPTS TEST OUTPUT_FOLDER
"""

import importlib.util
import os
import pathlib
import sys

import vtk
import vtk.test.Testing

SCRIPTS, NAME, OUTPUT = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])


def load(name):
    """Loads the script as a module, with the class replaced and calls that only the CPU mapper has removed."""
    text = (SCRIPTS / f"{name}.py").read_text()
    text = text.replace("vtkFixedPointVolumeRayCastMapper", "vtkGPUVolumeRayCastMapper")
    lines = [line for line in text.splitlines() if "SetNumberOfThreads" not in line]
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, None))
    sys.modules[name] = module
    exec(compile("\n".join(lines), name, "exec"), module.__dict__)  # pylint: disable=exec-used
    return module


def refine(window):
    """Gives VTK's mappers a tenth of their step size."""
    for renderer in window.GetRenderers():
        for volume in renderer.GetVolumes():
            mapper = volume.GetMapper()
            mapper.AutoAdjustSampleDistancesOff()
            mapper.SetSampleDistance(0.1 * min(mapper.GetInput().GetSpacing()))
    window.Render()


def save(window, *_, **__):
    if "REFINED_VTK" in os.environ:
        refine(window)
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(OUTPUT / f"{NAME}.png"))
    writer.Write()


vtk.test.Testing.compareImage = save
vtk.test.Testing.interact = lambda: None
load("TestFixedPointRayCasterNearest")
test = load(NAME)
getattr(getattr(test, NAME)(f"t{NAME[1:]}"), f"t{NAME[1:]}")()
