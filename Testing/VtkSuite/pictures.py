"""Differences of two images: the measure of VTK's own tests, and stricter ones."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def array_of(image):
    width, height, _ = image.GetDimensions()
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    return scalars.reshape(height, width, -1)[:, :, :3].astype(float)


def vtks_error(first, second):
    """vtkTesting::RegressionTest of VTK 9.1 passes up to 0.15."""
    difference = vtkImageDifference()
    difference.SetInputData(first)
    difference.SetImageData(second)
    difference.Update()
    return difference.GetThresholdedError()


def compare(first, second):
    """RMSE, 99.9th percentile and maximum of the channels' differences, in 1/255."""
    first, second = array_of(first), array_of(second)
    if first.shape != second.shape:
        return None
    differences = numpy.abs(first - second)
    return {
        "rmse": float(numpy.sqrt(numpy.mean(differences**2))),
        "most": float(numpy.percentile(differences, 99.9)),
        "largest": float(differences.max()),
        "bias": float(numpy.mean(first - second)),
    }


def compare_files(first, second):
    if not first.exists() or not second.exists():
        return None
    images = read(first), read(second)
    result = compare(*images)
    if result:
        result["vtk"] = vtks_error(*images)
    return result
