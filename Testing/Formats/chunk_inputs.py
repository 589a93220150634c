#!/usr/bin/env python3
"""Inputs in chunks and levels: Zarr of several programs, HDF5, Imaris, and what varimarch writes.

Each is compared with zarr-python, h5py, nibabel or tifffile, which also write them.
Usage: chunk_inputs.py [INPUT...]
"""

import json

import h5py
import nibabel
import numpy
import tifffile
import zarr

from comparison import Volume, affine_of, agree, from_ras, phantom, program, refused, run

MICROMETRE = 1e-3  # in mm
SIDES = "which side is the patient's left"


def placed(values, sizes, columns=numpy.eye(3), origin=(0, 0, 0)):
    """A volume whose axes x, y and z have sizes in mm along the columns of a matrix."""
    return Volume(values, affine_of(sizes, origin, columns))


def zarr_image(path, values, axes, scale, translation=None):
    """Writes OME-Zarr 0.4 with one level, and returns the array that zarr-python reads."""
    group = zarr.group(zarr.DirectoryStore(str(path)), overwrite=True)
    group.create_dataset("0", data=values, chunks=tuple(max(1, size // 2) for size in values.shape),
                         dimension_separator="/")
    transforms = [{"type": "scale", "scale": scale}]
    if translation:
        transforms.append({"type": "translation", "translation": translation})
    group.attrs["multiscales"] = [{"version": "0.4", "axes": axes, "datasets": [
        {"path": "0", "coordinateTransformations": transforms}]}]
    return zarr.open(str(path), mode="r")["0"][:]


# Zarr.


def sagittal_zarr_with_orientations(folder):
    """zarr-python: the axis called x runs to the feet, z to the right and y to the front."""
    directions = {"z": "left-to-right", "y": "posterior-to-anterior", "x": "superior-to-inferior"}
    stored = zarr_image(folder / "a.zarr", phantom(), [
        {"name": name, "type": "space", "unit": "millimeter",
         "orientation": {"type": "anatomical", "value": value}} for name, value in directions.items()],
        [2.5, 0.8, 0.7], [10.0, 20.0, 30.0])
    columns = numpy.array(((0, 0, -1), (0, -1, 0), (-1, 0, 0)), float)
    agree(folder / "a.zarr", placed(stored, (0.7, 0.8, 2.5), columns, (-10, -20, -30)))


def orientations_of_two_axes_are_not_enough(folder):
    """zarr-python: without the third direction the sides are unknown, and the axes are x, y, z."""
    directions = {"z": None, "y": "posterior-to-anterior", "x": "left-to-right"}
    stored = zarr_image(folder / "a.zarr", phantom(), [
        {"name": name, "type": "space", "unit": "micrometer",
         **({"orientation": {"type": "anatomical", "value": value}} if value else {})}
        for name, value in directions.items()], [2.0, 1.0, 1.0])
    agree(folder / "a.zarr", placed(stored, (MICROMETRE, MICROMETRE, 2 * MICROMETRE)), SIDES)


def times_behind_the_axes_of_space(folder):
    """zarr-python: the axes x, t, z, y in this order, with times in ms from 100 ms on."""
    axes = [{"name": "x", "type": "space", "unit": "nanometer"},
            {"name": "t", "type": "time", "unit": "millisecond"},
            {"name": "z", "type": "space", "unit": "nanometer"},
            {"name": "y", "type": "space", "unit": "nanometer"}]
    stored = zarr_image(folder / "a.zarr", phantom(shape=(6, 3, 4, 5)), axes,
                        [200.0, 50.0, 1000.0, 400.0], [0.0, 100.0, 0.0, 0.0])
    agree(folder / "a.zarr", [placed(stored[:, time].transpose(1, 2, 0), (2e-4, 4e-4, 1e-3))
                              for time in range(3)], SIDES, times=[0.1, 0.15, 0.2])


def xarray_with_falling_coordinates(folder):
    """zarr-python: an array of xarray [y, z, x] whose y falls, in cm, with a time before."""
    group = zarr.group(zarr.DirectoryStore(str(folder / "a.zarr")), overwrite=True)
    values = phantom(shape=(2, 5, 4, 6))
    group.create_dataset("t2", data=values, chunks=(1, 5, 4, 3)).attrs["_ARRAY_DIMENSIONS"] = [
        "time", "y", "z", "x"]
    for name, unit, places in (("time", "s", [0.0, 2.0]), ("y", "cm", 4 - 0.1 * numpy.arange(5)),
                               ("z", "mm", 30 + 2.5 * numpy.arange(4)), ("x", "mm", 0.5 * numpy.arange(6))):
        coordinates = group.create_dataset(name, data=numpy.array(places))
        coordinates.attrs.update({"_ARRAY_DIMENSIONS": [name], "units": unit})
    stored = zarr.open(str(folder / "a.zarr"), mode="r")["t2"][:]
    agree(folder / "a.zarr", [placed(one.transpose(1, 0, 2), (0.5, 1.0, 2.5), numpy.diag((1.0, -1.0, 1.0)),
                                     (0, 40, 30)) for one in stored], SIDES, times=[0, 2])


# HDF5.


def labels_of_hdf5_with_a_size_for_each_axis(folder):
    """h5py: labelled axes [x, time, y, z] with four sizes in um."""
    path = folder / "a.h5"
    with h5py.File(path, "w") as file:
        data = file.create_dataset("volume", data=phantom(shape=(6, 2, 5, 4)))
        data.attrs["element_size_um"] = (0.5, 1.0, 1.0, 2.0)
        for axis, name in enumerate(("x", "time", "y", "z")):
            data.dims[axis].label = name
    with h5py.File(path) as file:
        stored = file["volume"][:].transpose(1, 3, 2, 0)
    agree(path, [placed(one, (0.5e-3, 1e-3, 2e-3)) for one in stored], SIDES, times=[0, 1])


def ilastik_features_of_a_volume(folder):
    """h5py: ilastik's axes zyx with channels in the middle, of which the second is asked for."""
    path = folder / "a.ilp.h5"
    with h5py.File(path, "w") as file:
        data = file.create_dataset("exported_data", data=phantom(shape=(4, 7, 5, 6), kind="f4") / 9,
                                   chunks=(2, 7, 5, 3), compression="gzip")
        data.attrs["axistags"] = json.dumps({"axes": [{"key": key, "typeFlags": 2} for key in "zcyx"]})
    with h5py.File(path) as file:
        stored = file["exported_data"][:, 1]
    agree(path, placed(stored, (1, 1, 1)), "7 places", channel=1)


def imaris_in_nanometres_from_below_zero(folder):
    """h5py: an extent in nm, a size with padding, and two times over midnight."""
    path = folder / "a.ims"
    values = phantom(shape=(2, 4, 5, 6))

    def text(value):
        return numpy.array([letter.encode() for letter in str(value)], "S1")

    with h5py.File(path, "w") as file:
        image = file.create_group("DataSetInfo/Image")
        for axis, (low, high) in enumerate(((-600, 600), (0, 2000), (-8000, 0))):
            image.attrs[f"ExtMin{axis}"], image.attrs[f"ExtMax{axis}"] = text(low), text(high)
        image.attrs["Unit"] = text("nm")
        for time, moment in enumerate(("2024-02-29 23:59:59.500", "2024-03-01 00:00:01.000")):
            file.require_group("DataSetInfo/TimeInfo").attrs[f"TimePoint{time + 1}"] = text(moment)
            channel = file.create_group(f"DataSet/ResolutionLevel 0/TimePoint {time}/Channel 0")
            for axis, size in zip("XYZ", (6, 5, 4)):
                channel.attrs[f"ImageSize{axis}"] = text(size)
            channel.create_dataset("Data", data=numpy.pad(values[time], ((0, 4), (0, 3), (0, 2))),
                                   chunks=(8, 8, 8), compression="gzip")
    with h5py.File(path) as file:
        stored = [file[f"DataSet/ResolutionLevel 0/TimePoint {time}/Channel 0/Data"][:4, :5, :6]
                  for time in range(2)]
    # Extents are those of the outer faces of voxels.
    agree(path, [placed(one, (2e-4, 4e-4, 2e-3), origin=(-5e-4, 2e-4, -7e-3)) for one in stored],
          SIDES, times=[0, 1.5])


def oblique_image_of_itk(folder):
    """h5py: ITK's directions, one row for each axis, turned by 30 degrees about z."""
    path = folder / "a.h5"
    turn = numpy.array(((3**0.5 / 2, 0.5, 0), (-0.5, 3**0.5 / 2, 0), (0, 0, 1)))
    with h5py.File(path, "w") as file:
        group = file.create_group("ITKImage/0")
        group["VoxelData"], group["Directions"] = phantom(kind="f8") / 7, turn
        group["Spacing"], group["Origin"] = (0.7, 0.8, 2.5), (-10.0, 20.0, 30.0)
    with h5py.File(path) as file:
        stored, rows = file["ITKImage/0/VoxelData"][:], file["ITKImage/0/Directions"][:]
    agree(path, placed(stored, (0.7, 0.8, 2.5), rows.T, (-10, 20, 30)))


def matlab_logical_mask(folder):
    """h5py: MATLAB 7.3 stores [x, y, z] as [z, y, x], and truth values as bytes."""
    path = folder / "a.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        file.create_dataset("name", data=numpy.zeros((1, 5), "u2"))
        mask = file.create_dataset("mask", data=(phantom() > 500).astype("u1"))
        mask.attrs["MATLAB_class"] = numpy.bytes_("logical")
    path.write_bytes(b"MATLAB 7.3 MAT-file".ljust(512) + path.read_bytes()[512:])
    with h5py.File(path) as file:
        stored = file["mask"][:]
    agree(path, placed(stored, (1, 1, 1)), SIDES)


def complex_data_of_hdf5_are_refused(folder):
    """h5py: complex numbers are a compound of two."""
    with h5py.File(folder / "a.h5", "w") as file:
        file["a"] = phantom() * (1 + 2j)
    refused(folder / "a.h5", "none")


# Volumes that varimarch writes, read by other programs.


def nifti_in_any_order(folder):
    """nibabel and its matrix: a sagittal scan whose first axis runs to the feet."""
    matrix = numpy.array(((0, 0, 2.5, -10), (0, -0.8, 0, 20), (-0.7, 0, 0, 30), (0, 0, 0, 1.0)))
    nibabel.save(nibabel.Nifti1Image(phantom(kind="i2").T, matrix), str(folder / "a.nii.gz"))
    image = nibabel.load(str(folder / "a.nii.gz"))
    return folder / "a.nii.gz", Volume(image.get_fdata().T, from_ras(image.affine))


def zarr_of_a_sagittal_scan(folder):
    """nibabel and zarr-python: the written axes run to the left, the back and the head."""
    path, other = nifti_in_any_order(folder)
    program("convert", path, folder / "a.zarr")
    agree(folder / "a.zarr", other)
    group = zarr.open(str(folder / "a.zarr"), mode="r")
    axes = group.attrs["multiscales"][0]["axes"]
    assert [axis["orientation"]["value"] for axis in axes[-3:]] == [
        "inferior-to-superior", "anterior-to-posterior", "right-to-left"], axes
    # To the feet, to the front and to the right in the file of nibabel.
    expected = other.values.transpose(2, 1, 0)[::-1, :, ::-1]
    stored = group[group.attrs["multiscales"][0]["datasets"][0]["path"]][:].reshape(expected.shape)
    assert numpy.array_equal(stored, expected)


def tiff_of_a_sagittal_scan(folder):
    """nibabel and tifffile: the written pages run from the feet to the head."""
    path, other = nifti_in_any_order(folder)
    program("convert", path, folder / "a.tif")
    expected = other.values.transpose(2, 1, 0)[::-1, :, ::-1]
    stored = tifffile.imread(folder / "a.tif")
    assert numpy.array_equal(stored, expected)
    agree(folder / "a.tif", placed(stored, (2.5, 0.8, 0.7)), SIDES)


if __name__ == "__main__":
    run(globals())
