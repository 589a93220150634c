"""Volumes: from files and arrays to vtkImageData, and back."""

import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from .arguments import matrix_of_directions, three_numbers
from .VarimarchVolume import vtkVolumeFileReader
from .vtk_messages import vtk_messages_as_exceptions


def read(path):
    """The volume in a file, as vtkImageData placed in the patient (DICOM's LPS space, in mm).

    VTI, NRRD, MetaImage, NIfTI, InVesalius projects, and DICOM: a file, a DICOMDIR or a folder, of
    which the series with most images is read. For raw voxels, other series, and what else a file
    says, use vtkVolumeFileReader.

    Raises OSError with one sentence when the file cannot be read.
    """
    reader = vtkVolumeFileReader()
    reader.SetFileName(os.fspath(path))
    try:
        with vtk_messages_as_exceptions(reader):
            reader.Update()
    except RuntimeError as error:
        raise OSError(str(error)) from None
    return reader.GetOutput()


def to_image(array, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0), direction=None):
    """A vtkImageData with the values of an array [z, y, x] of integers or real numbers.

    The array's memory is shared where it is contiguous: do not change it while it is drawn, and call
    Modified() on the image's scalars after changing it. An array that is indexed [x, y, z], as
    nibabel's, is given as array.T.

    spacing, origin: along and of x, y, z, in this order as everywhere in VTK [mm].
    direction: 3 x 3, its columns the directions of x, y and z in the world; default: the axes.

    Raises ValueError or TypeError with one sentence for what is no volume.
    """
    values = volume_of(array)
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    spacing = three_numbers("spacing", spacing)
    if not (spacing > 0.0).all():
        raise ValueError(f"spacing: expected three numbers above 0, found {tuple(spacing)}")
    image.SetSpacing(spacing)
    image.SetOrigin(three_numbers("origin", origin))
    if direction is not None:
        image.SetDirectionMatrix(matrix_of_directions("direction", direction).ravel())
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1)))
    return image


def to_array(image):
    """The values of a vtkImageData as an array [z, y, x], or [z, y, x, component] with several.

    Shares the image's memory.
    """
    scalars = image.GetPointData().GetScalars()
    if scalars is None:
        raise ValueError("the image has no scalars")
    shape = image.GetDimensions()[::-1]
    if scalars.GetNumberOfComponents() > 1:
        shape += (scalars.GetNumberOfComponents(),)
    return vtk_to_numpy(scalars).reshape(shape)


def volume_of(array):
    """The array in a type and an order that VTK has, with a dimension of its own for x, y and z."""
    values = numpy.asarray(array)
    if values.ndim != 3 or min(values.shape) < 2:
        raise ValueError(
            "volume: expected an array [z, y, x] of at least 2 values along each, "
            f"found one of shape {values.shape}"
        )
    if values.dtype.kind not in "biuf":
        raise TypeError(
            f"volume: expected integers or real numbers, found values of type {values.dtype}"
        )
    if values.dtype.kind == "b":
        values = values.astype(numpy.uint8)
    elif values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):
        values = values.astype(numpy.float32 if values.dtype.itemsize < 4 else numpy.float64)
    return numpy.ascontiguousarray(values, values.dtype.newbyteorder("="))
