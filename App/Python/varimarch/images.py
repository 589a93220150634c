"""Conversion of volumes from files and arrays to vtkImageData, and back."""

import operator
import os
import warnings

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkCommonDataModel import vtkImageData

from .arguments import (
    instance,
    matrix_of_directions,
    named_type,
    number,
    three_numbers,
    whole_number,
)
from .VarimarchVolume import vtkVolumeFileReader
from .vtk_messages import vtk_messages_as_exceptions


def read(path, level=None, channel=0, memory=None, time=None, files_are_times=False, kind=None,
         rectify=None):
    """Reads a volume file as vtkImageData in patient coordinates (DICOM's LPS space, in mm).

    Formats: VTI, NRRD, MetaImage, NIfTI, OME-Zarr, HDF5 (Imaris, BigDataViewer), InVesalius projects,
    DICOM and others. For DICOM, the path is that of a file, a DICOMDIR or a folder, and the series with
    the most images is read. For raw voxels, other series, and metadata, use vtkVolumeFileReader.

    level: the level to read of OME-Zarr, Imaris or BigDataViewer, the finest of which is 0; default:
        the finest that fits in half of the free memory, or that can be drawn from its chunks.
    channel: the channel to read of these formats, counted from 0; or "all" for two to four channels
        as components, as the program and the viewer read them if they fit in memory.
    memory: bytes of memory that the program may use; default: all of the machine's. Voxels that need
        more than a quarter of it stay in their file, if that has them uncompressed, as single numbers
        of 8 bits, 16 bits or type float: NRRD, MetaImage and NIfTI. The image's scalars are then a
        mapping of the file, which is drawn from disk.
    time: the number of one of several times, counted from 0; times(path) lists them. Default: the
        first, with a Python warning that there are others.
    files_are_times: True if the volumes in a folder, or those beside a file whose names differ from
        its own only in the last number before the first dot, are times.
    kind: the kind of volume to read of a DICOM series that holds several, such as echoes, b-values,
        views or stations, counted from 1. Default: the first, with a Python warning that lists all.
    rectify: True resamples the slices of a tilted or uneven DICOM series on an even grid, False keeps
        them as scanned. Default: as the program does, only if slices would lie elsewhere than they
        were scanned and no gap is wider than four usual distances.

    Doubtful input, such as a missing slice, is a Python warning. Raises OSError with one sentence if the file cannot be read.
    """
    reader = vtkVolumeFileReader()
    reader.SetResolutionLevel(-1 if level is None else whole_number("level", level))
    reader.SetChannel(-1 if channel == "all" else whole_number("channel", channel))
    reader.SetDICOMKind(0 if kind is None else whole_number("kind", kind))
    reader.SetRectifySlices(rectify is not None and bool(rectify))
    reader.SetRectifyMisplacedSlices(rectify is None)
    if memory is not None:
        reader.SetMaximumHostMemory(int(number("memory", memory, 1, 2**62)))
    update(reader, path, 0 if time is None else time, files_are_times)
    if time is None and reader.GetNumberOfTimes() > 1:
        message = (f"{path}: the file holds {reader.GetNumberOfTimes()} times; the first was read, and "
                   "the argument time chooses another")
        warnings.warn(message, RuntimeWarning, stacklevel=2)
    doubts = reader.GetWarnings()
    for doubt in range(doubts.GetNumberOfValues()):
        # Level 1 is this function, level 2 its caller.
        warnings.warn(doubts.GetValue(doubt), RuntimeWarning, stacklevel=2)
    return reader.GetOutput()


def times(path, files_are_times=False):
    """Returns the times of a volume file as an array, in seconds if the file states them.

    Otherwise it holds their numbers 0, 1, 2 ...; it has one element for a single volume.
    read(path, time=i) reads the volume of the i-th.
    """
    reader = vtkVolumeFileReader()
    update(reader, path, 0, files_are_times)
    return numpy.array([reader.GetTimeValue(time) for time in range(reader.GetNumberOfTimes())])


def update(reader, path, time, files_are_times):
    """Lets a vtkVolumeFileReader read one time of a file."""
    reader.SetFileName(os.fspath(path))
    reader.SetTimeIndex(operator.index(time))
    reader.SetFilesAreTimes(bool(files_are_times))
    try:
        with vtk_messages_as_exceptions(reader):
            reader.Update()
    except RuntimeError as error:
        raise OSError(str(error)) from None


def to_image(array, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0), direction=None):
    """Returns a vtkImageData with the values of an array [z, y, x] of integers or real numbers.

    An array [z, y, x, component] has 2 to 4 components.

    A contiguous array shares its memory with the image: do not change it while it is drawn, and call
    Modified() on the image's scalars after changing it. If an array is indexed [x, y, z], as those
    of nibabel are, pass array.T. The masked values of a numpy.ma.MaskedArray become NaN, in a copy:
    such voxels have no value.

    spacing: distances between voxels along x, y, z, in this order as everywhere in VTK [mm].
    origin: position of the first voxel, x, y, z [mm].
    direction: 3 x 3, whose columns are the directions of x, y and z in world space; default: the
        axes.

    Raises ValueError or TypeError with one sentence if the array is not a volume.
    """
    values = volume_of(array)
    image = vtkImageData()
    image.SetDimensions(values.shape[2::-1])
    spacing = three_numbers("spacing", spacing)
    if not (spacing > 0.0).all():
        raise ValueError(f"spacing: expected three numbers above 0, found {tuple(spacing)}")
    image.SetSpacing(spacing)
    image.SetOrigin(three_numbers("origin", origin))
    if direction is not None:
        image.SetDirectionMatrix(matrix_of_directions("direction", direction).ravel())
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, *values.shape[3:])))
    return image


def to_array(image):
    """Returns the values of a vtkImageData as an array [z, y, x].

    With several components it is indexed [z, y, x, component]. It shares the image's memory.
    """
    advice = "read(path) and to_image(array) return one"
    scalars = instance("image", image, vtkImageData, advice).GetPointData().GetScalars()
    if scalars is None:
        raise ValueError("the image has no scalars")
    shape = image.GetDimensions()[::-1]
    if scalars.GetNumberOfComponents() > 1:
        shape += (scalars.GetNumberOfComponents(),)
    return vtk_to_numpy(scalars).reshape(shape)


def check_is_array(array):
    """Raises a TypeError that says what helps, given an object that is often passed instead."""
    if isinstance(array, (str, os.PathLike)):
        raise TypeError(
            f"volume: expected an array or a vtkImageData, found the path {os.fspath(array)!r}; "
            "read it by varimarch.read(path)"
        )
    if array is None or isinstance(array, vtkObjectBase):
        raise TypeError(
            f"volume: expected an array or a vtkImageData, found {named_type(array)}; "
            "vtkVariationFieldVolumeMapper also renders a vtkRectilinearGrid, and vtkResampleToImage "
            "makes an image of other data"
        )


def without_mask(array):
    """Returns an array with NaN where a masked array has no value."""
    if not numpy.ma.is_masked(array) or array.dtype.kind not in "biuf":
        return array.data
    floats = numpy.float32 if array.dtype.itemsize <= 2 else numpy.float64
    kept = array.dtype if array.dtype.kind == "f" else floats
    return array.astype(kept).filled(numpy.nan)


def volume_of(array):
    """Returns an array [z, y, x] or [z, y, x, component] in a type and an order that VTK supports."""
    check_is_array(array)
    values = without_mask(array) if numpy.ma.isMaskedArray(array) else numpy.asarray(array)
    has_components = values.ndim == 4 and 2 <= values.shape[3] <= 4
    if values.ndim - has_components != 3 or min(values.shape[:3]) < 2:
        raise ValueError(
            "volume: expected an array [z, y, x] of at least 2 values along each, or "
            f"[z, y, x, component] of 2 to 4 components, found one of shape {values.shape}"
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


def image_of(volume, spacing):
    if not isinstance(volume, vtkImageData):
        return to_image(volume, (1.0, 1.0, 1.0) if spacing is None else spacing)
    if spacing is not None:
        raise ValueError("spacing: expected only with an array; the vtkImageData has its own")
    has_cells_only = not volume.GetPointData().GetScalars() and volume.GetCellData().GetScalars()
    return voxels_of_cells(volume) if has_cells_only else volume


def voxels_of_cells(image):
    """Returns an image with a voxel in the middle of each cell, which shares the values."""
    extent = image.GetExtent()
    last = [max(extent[2 * axis + 1] - 1, extent[2 * axis]) for axis in range(3)]
    # A single layer of points is a single layer of flat cells.
    middle = [0.5 if extent[2 * axis + 1] > extent[2 * axis] else 0.0 for axis in range(3)]
    origin = [0.0, 0.0, 0.0]
    image.TransformContinuousIndexToPhysicalPoint(middle, origin)
    voxels = vtkImageData()
    voxels.SetExtent(extent[0], last[0], extent[2], last[1], extent[4], last[2])
    voxels.SetOrigin(origin)
    voxels.SetSpacing(image.GetSpacing())
    voxels.SetDirectionMatrix(image.GetDirectionMatrix())
    voxels.GetPointData().SetScalars(image.GetCellData().GetScalars())
    voxels.SetFieldData(image.GetFieldData())
    return voxels
