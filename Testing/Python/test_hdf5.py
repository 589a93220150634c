#!/usr/bin/env python3
"""Volumes in HDF5 that h5py writes: plain ones, those of Imaris, and those of BigDataViewer.

Usage: test_hdf5.py CASE VARIMARCH
"""

import itertools
import json
import pathlib
import sys
import tempfile

import h5py
import numpy
import varimarch

from pyramid_reading import TYPES, expect_refused, read, values_of


def write_imaris(path, values, channels=1):
    """A file as Imaris writes it, with a padded data set and a second level."""
    def letters(text):
        return numpy.array([letter.encode() for letter in str(text)], "S1")

    with h5py.File(path, "w") as file:
        image = file.create_group("DataSetInfo/Image")
        for axis, (low, high) in enumerate(((10.0, 21.0), (-4.0, 14.0), (0.0, 14.0))):
            image.attrs[f"ExtMin{axis}"] = letters(low)
            image.attrs[f"ExtMax{axis}"] = letters(high)
        image.attrs["Unit"] = letters("um")
        for level, channel in itertools.product(range(2), range(channels)):
            step = level + 1
            array = values[::step, ::step, ::step] + numpy.uint16(channel)
            group = file.create_group(
                f"DataSet/ResolutionLevel {level}/TimePoint 0/Channel {channel}")
            for name, size in zip("ZYX", array.shape):
                group.attrs[f"ImageSize{name}"] = letters(size)
            padded = numpy.pad(array, ((0, 1), (0, 2), (0, 3)))
            group.create_dataset("Data", data=padded, chunks=(4, 4, 4), compression="gzip")


def imaris_files_lie_where_they_say(folder):
    """Sizes without padding, spacing and position, levels and channels."""
    values = values_of((7, 9, 11), "u2")
    write_imaris(folder / "a.ims", values, 2)
    found, image, doubts = read(folder / "a.ims")
    assert (found == values).all()
    assert numpy.allclose(image.GetSpacing(), (1e-3, 2e-3, 2e-3))
    assert numpy.allclose(image.GetOrigin(), (10.5e-3, -3e-3, 1e-3))
    assert any("2 channels" in doubt for doubt in doubts), doubts
    found, image, _ = read(folder / "a.ims", channel="all")
    assert (found == numpy.stack((values, values + numpy.uint16(1)), axis=-1)).all()
    assert image.GetPointData().GetScalars().GetComponentName(1) == "Channel 2"
    found, image, _ = read(folder / "a.ims", level=1, channel=1)
    assert (found == values[::2, ::2, ::2] + numpy.uint16(1)).all()
    assert numpy.allclose(image.GetSpacing(), (11e-3 / 6, 18e-3 / 5, 14e-3 / 4))


def bigdataviewer_files_have_levels_and_a_description(folder):
    """The voxels are read by the name of either file; the size of a voxel is in the description."""
    values = values_of((6, 8, 10), "u2")
    half = values[:, ::2, ::2]
    with h5py.File(folder / "a.h5", "w") as file:
        for setup in range(2):
            file[f"s{setup:02}/resolutions"] = numpy.array(((1, 1, 1), (2, 2, 1)), "f8")
            for level, array in enumerate((values, half)):
                shifted = array + numpy.uint16(setup)
                file.create_dataset(f"t00000/s{setup:02}/{level}/cells", chunks=(3, 4, 4),
                                    data=numpy.ascontiguousarray(shifted).view("i2"))
    found, image, doubts = read(folder / "a.h5")
    assert found.dtype == numpy.uint16 and (found == values).all()
    assert any("1 mm" in doubt for doubt in doubts), doubts
    setups = "".join(
        f"<ViewSetup><id>{setup}</id><voxelSize><unit>um</unit><size>{setup + 1} 2 3</size>"
        "</voxelSize></ViewSetup>" for setup in range(2))
    (folder / "a.xml").write_text(
        '<?xml version="1.0"?><SpimData version="0.2"><SequenceDescription>'
        '<ImageLoader format="bdv.hdf5"><hdf5 type="relative">a.h5</hdf5></ImageLoader>'
        f"<ViewSetups>{setups}</ViewSetups></SequenceDescription></SpimData>")
    for name in ("a.h5", "a.xml"):
        found, image, _ = read(folder / name)
        assert (found == values).all() and numpy.allclose(image.GetSpacing(), (1e-3, 2e-3, 3e-3))
    found, image, _ = read(folder / "a.xml", level=1, channel=1)
    assert (found == half + numpy.uint16(1)).all()
    assert numpy.allclose(image.GetSpacing(), (4e-3, 4e-3, 3e-3))
    assert numpy.allclose(image.GetOrigin(), (1e-3, 1e-3, 0.0))
    expect_refused(folder / "a.xml", "2 setups", channel=2)
    (folder / "a.h5").unlink()
    expect_refused(folder / "a.xml", "a.h5", "no file of this name")


def times_of_hdf5_are_chosen(folder):
    """Times of Imaris, with the moments that it states or numbers, and of BigDataViewer."""
    volumes = [values_of((7, 9, 11), "u2", seed) for seed in range(3)]

    def write(seconds):
        write_imaris(folder / "a.ims", volumes[0])
        with h5py.File(folder / "a.ims", "r+") as file:
            for time, values in enumerate(volumes):
                if time > 0:
                    for level in range(2):
                        group = f"DataSet/ResolutionLevel {level}/TimePoint"
                        file.copy(f"{group} 0", f"{group} {time}")
                file[f"DataSet/ResolutionLevel 0/TimePoint {time}/Channel 0/Data"][:7, :9, :11] = values
                moment = f"2024-02-29 23:59:{seconds[time]}"
                file.require_group("DataSetInfo/TimeInfo").attrs[f"TimePoint{time + 1}"] = (
                    numpy.array([letter.encode() for letter in moment], "S1"))

    write(("50.250", "52.000", "53.750"))
    with h5py.File(folder / "b.h5", "w") as file:
        file["s00/resolutions"] = numpy.array(((1, 1, 1),), "f8")
        for time, values in enumerate(volumes):
            file.create_dataset(f"t{time:05}/s00/0/cells", data=values.view("i2"), chunks=(3, 4, 4))
    for name, expected in ("a.ims", [0.0, 1.75, 3.5]), ("b.h5", [0.0, 1.0, 2.0]):
        assert list(varimarch.times(str(folder / name))) == expected
        for time, values in enumerate(volumes):
            found, _, doubts = read(folder / name, time=time)
            assert (found == values).all(), (name, time)
            assert not any("times" in doubt for doubt in doubts), doubts
        expect_refused(folder / name, "a time from 0 to 2", time=3)
    write(("50", "later", "53"))
    assert (read(folder / "a.ims", time=2)[0] == volumes[2]).all()
    with h5py.File(folder / "a.ims", "r+") as file:
        del file["DataSet/ResolutionLevel 1/TimePoint 2/Channel 0/Data"]
    expect_refused(folder / "a.ims", "ResolutionLevel 1/TimePoint 2", time=2)


def data_sets_of_hdf5_have_the_values_of_h5py(folder):
    """Types, byte orders and compressions; the largest data set, or the one that a path names."""
    for number, (kind, order) in enumerate(itertools.product(TYPES, "<>")):
        values = values_of(kind=kind, seed=number)
        path = folder / f"{number}.h5"
        packing = {"chunks": (3, 4, 5), "compression": "gzip", "shuffle": True} if number % 3 else {}
        with h5py.File(path, "w") as file:
            file.create_dataset("volumes/raw", data=values.astype(order + kind), **packing)
            file["volumes/raw"].attrs["element_size_um"] = (3.0, 2.0, 1.0)
            file["small"] = values[:2]
            file["text"] = "words"
        found, image, doubts = read(path)
        assert found.dtype == numpy.dtype(kind) and (found == values).all(), kind
        assert numpy.allclose(image.GetSpacing(), (1e-3, 2e-3, 3e-3))
        assert any("/volumes/raw" in doubt for doubt in doubts), doubts
        assert (read(f"{path}/small")[0] == values[:2]).all()
        expect_refused(f"{path}/none", "/none")


def place_of(image, *index):
    """The position of a voxel."""
    place = [0.0] * 3
    image.TransformIndexToPhysicalPoint(*index, place)
    return place


def axes_of_hdf5_have_the_names_of_their_files(folder):
    """The tags of ilastik and the labels of HDF5, with channels and times."""
    values = values_of((3, 4, 5))
    path = folder / "a.h5"

    def write(array, names, with_tags):
        with h5py.File(path, "w") as file:
            data = file.create_dataset("exported_data", data=array)
            if with_tags:
                data.attrs["axistags"] = json.dumps({"axes": [
                    {"key": name, "typeFlags": 2, "resolution": 0, "description": ""} for name in names]})
            else:
                for axis, name in enumerate(names):
                    data.dims[axis].label = name

    for with_tags, names in itertools.product((True, False), itertools.permutations("xyz")):
        write(values, names, with_tags)
        found, image, doubts = read(path)
        assert (found == values).all()
        # The element [1, 2, 3].
        assert place_of(image, 3, 2, 1) == [float(names.index(axis) + 1) for axis in "xyz"], names
        assert any("mirrored" in doubt for doubt in doubts), doubts
    several = values_of((2, 3, 4, 5, 3))
    write(several, "tzyxc", True)
    found, _, doubts = read(path, channel=2, time=1)
    assert (found == several[1, ..., 2]).all()
    assert (read(path, channel="all")[0] == several[0]).all()
    assert len(varimarch.times(str(path))) == 2
    expect_refused(path, "channel from 0 to 2", channel=3)
    with h5py.File(path, "w") as file:
        file.create_dataset("a", data=values).attrs["axistags"] = "{damaged"
    assert (read(path)[0] == values).all()


def hdf5_scales_place_their_axes(folder):
    """The scales of netCDF-4 name the axes, and have their coordinates and units."""
    values = values_of((5, 4, 3))
    path = folder / "a.nc"
    with h5py.File(path, "w") as file:
        data = file.create_dataset("group/ct", data=values)
        for axis, (name, unit, places) in enumerate((
                ("x", "cm", -1 + 0.1 * numpy.arange(5)), ("y", "mm", 20 - 2.0 * numpy.arange(4)),
                ("z", "mm", 30 + 3.0 * numpy.arange(3)))):
            file[name] = places
            file[name].attrs["units"] = unit
            file[name].make_scale(name)
            data.dims[axis].attach_scale(file[name])
    found, image, doubts = read(path)
    assert (found == values).all()
    # The element [3, 2, 1].
    assert numpy.allclose(place_of(image, 1, 2, 3), (-7.0, 16.0, 33.0)), place_of(image, 1, 2, 3)
    assert not any("1 mm" in doubt for doubt in doubts), doubts


def hdf5_states_the_size_of_voxels_for_all_axes_or_those_of_space(folder):
    """Four sizes for four axes, three for the last, and sizes that are none."""
    path = folder / "a.h5"
    values = values_of((2, 3, 4, 5))
    for array, sizes, spacing, doubt in (
            (values, (1.0, 3.0, 2.0, 1.0), (1e-3, 2e-3, 3e-3), ""),
            (values, (3.0, 2.0, 1.0), (1e-3, 2e-3, 3e-3), ""),
            (values[0], (0.0, 2.0, 1.0), (1e-3, 2e-3, 1e-3), "0 um long along axis 0"),
            (values[0], (3.0, 2.0), (1.0, 1.0, 1.0), "1 mm")):
        with h5py.File(path, "w") as file:
            file.create_dataset("a", data=array).attrs["element_size_um"] = sizes
        found, image, doubts = read(path)
        assert numpy.allclose(image.GetSpacing(), spacing), (sizes, image.GetSpacing())
        assert any(doubt and doubt in one for one in doubts) == bool(doubt), (sizes, doubts)


def hdf5_of_other_programs_is_read(folder):
    """Booleans of h5py, MATLAB's block before the file, and images of ITK with their geometry."""
    values = values_of((3, 4, 5))
    with h5py.File(folder / "bool.h5", "w") as file:
        file["mask"] = values % 2 == 0
    assert (read(folder / "bool.h5")[0] == (values % 2 == 0)).all()
    matlab = folder / "v73.mat"
    with h5py.File(matlab, "w", userblock_size=512) as file:
        file["V"] = values
    matlab.write_bytes(b"MATLAB 7.3 MAT-file".ljust(512) + matlab.read_bytes()[512:])
    assert (read(matlab)[0] == values).all()

    def write_itk(array, directions):
        with h5py.File(folder / "itk.h5", "w") as file:
            group = file.create_group("ITKImage/0")
            group["VoxelData"] = array
            group["Spacing"] = (0.5, 2.0, 3.0)
            group["Origin"] = (-1.0, 7.0, 30.0)
            group["Directions"] = directions

    turned = numpy.array(((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))  # one row for each axis
    write_itk(values, turned)
    found, image, doubts = read(folder / "itk.h5")
    assert (found == values).all() and not doubts, doubts
    assert numpy.allclose(place_of(image, 3, 2, 1), (-5.0, 8.5, 33.0))
    colours = values_of((3, 4, 5, 3), "u1")
    write_itk(colours, turned)
    assert (read(folder / "itk.h5", channel=1)[0] == colours[..., 1]).all()


def hdf5_says_what_is_not_done(folder):
    """A map of values, and a description of BigDataViewer that turns the volume."""
    values = values_of((3, 4, 5), "u2")
    with h5py.File(folder / "a.h5", "w") as file:
        file.create_dataset("a", data=values).attrs.update({"scale_factor": 0.25, "add_offset": -1.0})
    assert any("0.25 times" in doubt for doubt in read(folder / "a.h5")[2])
    with h5py.File(folder / "b.h5", "w") as file:
        file["s00/resolutions"] = numpy.array(((1, 1, 1),), "f8")
        file.create_dataset("t00000/s00/0/cells", data=values.view("i2"), chunks=(3, 4, 4))

    def doubts_of(*affines):
        transforms = "".join(f'<ViewTransform type="affine"><affine>{text}</affine></ViewTransform>'
                             for text in affines)
        (folder / "b.xml").write_text(
            '<?xml version="1.0"?><SpimData version="0.2"><SequenceDescription>'
            '<ImageLoader format="bdv.hdf5"><hdf5 type="relative">b.h5</hdf5></ImageLoader>'
            "<ViewSetups><ViewSetup><id>0</id><voxelSize><unit>um</unit><size>1 1 3</size></voxelSize>"
            "</ViewSetup></ViewSetups></SequenceDescription><ViewRegistrations>"
            f'<ViewRegistration timepoint="0" setup="0">{transforms}</ViewRegistration>'
            "</ViewRegistrations></SpimData>")
        return read(folder / "b.xml")[2]

    scale = "1 0 0 0 0 1 0 0 0 0 3 0"
    said = [any("ViewRegistration" in doubt for doubt in doubts_of(*affines)) for affines in (
        (scale,), ("2 0 0 0 0 2 0 0 0 0 2 0", scale), ("1 0 0 5 0 1 0 0 0 0 1 0", scale),
        ("0 -1 0 0 1 0 0 0 0 0 1 0", scale), ("1 0 0 0 0 1 0 0 0 0 2 0", scale))]
    assert said == [False, False, True, True, True], said


def hdf5_of_numbers_with_unused_bits_has_the_values_of_h5py(folder):
    """Types of HDF5 that NumPy does not have: integers of 12 of 32 bits and of 24 bits, and halves."""
    narrow = h5py.h5t.STD_I32LE.copy()
    narrow.set_precision(12)
    odd = h5py.h5t.STD_U32LE.copy()
    odd.set_precision(24)
    odd.set_size(3)
    for kind, limits in ((narrow, (-2**11, 2**11)), (odd, (0, 2**24)), (h5py.h5t.IEEE_F16BE, (0, 2**11))):
        values = numpy.random.default_rng(1).integers(*limits, (4, 5, 6), numpy.int32)
        with h5py.File(folder / "a.h5", "w") as file:
            space = h5py.h5s.create_simple(values.shape)
            data = h5py.h5d.create(file.id, b"a", kind, space)
            data.write(h5py.h5s.ALL, h5py.h5s.ALL, values)
        assert (read(folder / "a.h5")[0] == values).all(), kind


def bad_hdf5_is_one_sentence(folder):
    """Files that were cut, and files without a volume."""
    path = folder / "a.h5"
    with h5py.File(path, "w") as file:
        file.create_dataset("a", data=values_of((4, 5, 6)), chunks=(2, 5, 6), compression="gzip")
    whole = path.read_bytes()
    for size in range(8, len(whole), max(1, len(whole) // 30)):
        path.write_bytes(whole[:size])
        expect_refused(path)
    with h5py.File(path, "w") as file:
        file["a"] = 1
    expect_refused(path, "three axes")
    with h5py.File(path, "w") as file:
        file.create_dataset("a", shape=(2**20,) * 3, chunks=(64,) * 3, dtype="u2")
    expect_refused(path, "in the memory of")
    write_imaris(path, values_of((7, 9, 11), "u2"))
    with h5py.File(path, "r+") as file:
        del file["DataSetInfo/Image"].attrs["ExtMax1"]
    expect_refused(path, "ExtMax1")
    (folder / "a.xml").write_text("<?xml version='1.0'?><SpimData><SequenceDescription>")
    expect_refused(folder / "a.xml", "BigDataViewer")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
