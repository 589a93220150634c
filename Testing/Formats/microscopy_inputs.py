#!/usr/bin/env python3
"""Inputs of microscopes and tables: TIFF in its dialects, MRC, NumPy.

Each is compared with tifffile, mrcfile or NumPy, which also write most of them.
Usage: microscopy_inputs.py [INPUT...]
"""

import struct

import mrcfile
import numpy
import tifffile

from comparison import Volume, affine_of, agree, phantom, refused, run

MICROMETRE = 1e-3  # in mm
ANGSTROM = 1e-7


def in_micrometres(values, x=1.0, y=1.0, z=1.0):
    """A volume at the origin whose voxels have a size in micrometres."""
    return Volume(values, affine_of(numpy.array((x, y, z)) * MICROMETRE, (0, 0, 0)))


def in_millimetres(values):
    """A volume at the origin whose voxels have the size that is taken where a file has none."""
    return Volume(values, affine_of((1, 1, 1), (0, 0, 0)))


def per_micrometre(size):
    """What tifffile needs for pixels of a size in ImageJ's unit um."""
    return {"resolution": (1 / size, 1 / size)}


# ImageJ.


def calibrated_hyperstack_of_imagej(folder):
    """tifffile: times, slices, a straight line of values, and an interval in ms."""
    values = phantom(shape=(3, 4, 5, 6))
    path = folder / "a.tif"
    tifffile.imwrite(path, values, imagej=True, **per_micrometre(0.5), metadata={
        "axes": "TZYX", "spacing": 2.0, "unit": "um", "finterval": 40, "tunit": "ms",
        "cf": 0, "c0": -1000.0, "c1": 0.25})
    with tifffile.TiffFile(path) as file:
        tags = file.imagej_metadata
        stored = file.series[0].asarray()
    assert stored.shape == (3, 4, 5, 6) and float(tags["c1"]) == 0.25, (stored.shape, tags)
    agree(path, [in_micrometres(-1000 + 0.25 * one, 0.5, 0.5, 2.0) for one in stored],
          times=[0, 0.04, 0.08])


def signed_shorts_as_imagej_saves_them(folder):
    """tifffile: unsigned pixels, of which the description takes away 32768."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom() + 32000, imagej=True, **per_micrometre(1.0), metadata={
        "axes": "ZYX", "unit": "um", "spacing": 1.0, "cf": 0, "c0": -32768.0, "c1": 1.0, "vunit": "HU"})
    agree(path, in_micrometres(tifffile.imread(path).astype(float) - 32768))


def curve_of_imagej_is_named(folder):
    """tifffile: optical density, a function that is no straight line."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(), imagej=True, **per_micrometre(1.0), metadata={
        "axes": "ZYX", "unit": "um", "spacing": 1.0, "cf": 8, "c0": 1.0, "c1": 2.0})
    agree(path, in_micrometres(tifffile.imread(path)), "function number 8")


def imagej_with_one_directory(folder):
    """tifffile: 2 channels and 4 slices in big endian behind a single directory."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(shape=(4, 2, 5, 6)), imagej=True, truncate=True, byteorder=">",
                     **per_micrometre(0.5), metadata={"axes": "ZCYX", "spacing": 2.0, "unit": "micron"})
    stored = tifffile.imread(path)
    agree(path, in_micrometres(numpy.moveaxis(stored, 1, -1), 0.5, 0.5, 2.0))


# OME.


def ome_with_units_of_its_own_per_axis(folder):
    """tifffile: nm in the plane and um along z, with times in ms, channels slower than slices."""
    path = folder / "a.ome.tif"
    tifffile.imwrite(path, phantom(shape=(2, 3, 4, 5, 6)), ome=True, metadata={
        "axes": "TCZYX", "PhysicalSizeX": 250.0, "PhysicalSizeXUnit": "nm", "PhysicalSizeY": 500.0,
        "PhysicalSizeYUnit": "nm", "PhysicalSizeZ": 1.5, "PhysicalSizeZUnit": "\u00b5m",
        "TimeIncrement": 250.0, "TimeIncrementUnit": "ms"})
    stored = tifffile.imread(path)
    agree(path, [in_micrometres(numpy.moveaxis(one, 0, -1), 0.25, 0.5, 1.5) for one in stored],
          times=[0, 0.25])


def ome_with_small_copies_of_its_pages(folder):
    """tifffile: copies of half the size in directories below those of the pages are no slices."""
    path = folder / "a.ome.tif"
    values = phantom(shape=(4, 32, 32))
    with tifffile.TiffWriter(path, ome=True) as writer:
        options = {"tile": (16, 16), "compression": "zlib"}
        writer.write(values, subifds=1, **options, metadata={
            "axes": "ZYX", "PhysicalSizeX": 1.0, "PhysicalSizeY": 1.0, "PhysicalSizeZ": 2.0})
        writer.write(values[:, ::2, ::2], subfiletype=1, **options)
    agree(path, in_micrometres(tifffile.imread(path), 1.0, 1.0, 2.0))


def ome_in_two_files_of_one_set(folder):
    """tifffile: slices whose pages are in two files, either of which opens the whole."""
    values = phantom(shape=(4, 5, 6))
    ids = [f"urn:uuid:00000000-0000-0000-0000-00000000000{number}" for number in range(2)]
    names = ["low.ome.tif", "high.ome.tif"]
    planes = "".join(
        f'<TiffData FirstZ="{z}" FirstC="0" FirstT="0" IFD="{z % 2}" PlaneCount="1">'
        f'<UUID FileName="{names[z // 2]}">{ids[z // 2]}</UUID></TiffData>' for z in range(4))
    for number, name in enumerate(names):
        tifffile.imwrite(folder / name, values[2 * number:2 * number + 2], metadata=None, description=(
            f'<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" '
            f'UUID="{ids[number]}"><Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" '
            'Type="uint16" SizeX="6" SizeY="5" SizeZ="4" SizeC="1" SizeT="1" PhysicalSizeX="0.5" '
            f'PhysicalSizeY="0.5" PhysicalSizeZ="2">{planes}</Pixels></Image></OME>'))
    for name in names:
        agree(folder / name, in_micrometres(tifffile.imread(folder / name), 0.5, 0.5, 2.0))


# tifffile's own axes, and further TIFF.


def compressed_times_and_channels_of_tifffile(folder):
    """tifffile: axes of time, channel and height in compressed differences of big endian."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(shape=(2, 2, 5, 6, 7), kind="i2") - 500,
                     metadata={"axes": "TCZYX"}, compression="zlib", predictor=True, byteorder=">",
                     bigtiff=True)
    stored = tifffile.imread(path)
    agree(path, [in_millimetres(numpy.moveaxis(one, 0, -1)) for one in stored], times=[0, 1])


def places_of_a_stage_are_not_slices(folder):
    """tifffile: positions of a stage before the slices: the first, and a warning names the axis."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(shape=(3, 5, 6, 7)), metadata={"axes": "RZYX"})
    agree(path, in_millimetres(tifffile.imread(path)[0]), "axis R has 3 places")


def slices_that_were_stored_as_planes_of_colour(folder):
    """tifffile: before 2024 it took four slices for red, green, blue and alpha, but names their axis."""
    path = folder / "a.tif"
    for shape, axes in ((4, 5, 6), "ZYX"), ((3, 4, 5, 6), "TZYX"), ((2, 3, 5, 6), "CZYX"):
        tifffile.imwrite(path, phantom(shape=shape), metadata={"axes": axes}, photometric="rgb",
                         planarconfig="separate")
        stored = tifffile.imread(path)
        assert stored.shape == shape, stored.shape
        if axes[0] == "C":
            agree(path, in_millimetres(numpy.moveaxis(stored, 0, -1)))
        else:
            agree(path, [in_millimetres(one) for one in stored.reshape((-1, *shape[-3:]))])


def as_many_slices_as_colours(folder):
    """tifffile: three slices of red, green and blue, whose axes are ZYXS."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(shape=(3, 5, 6, 3), kind="u1"), metadata={"axes": "ZYXS"},
                     photometric="rgb")
    agree(path, in_millimetres(tifffile.imread(path)))


def slices_in_deep_tiles(folder):
    """tifffile: five slices of one directory in tiles of four, so that the last reach beyond."""
    path = folder / "a.tif"
    tifffile.imwrite(path, phantom(shape=(5, 20, 24)), tile=(4, 16, 16), volumetric=True, metadata=None)
    agree(path, in_millimetres(tifffile.imread(path)))


def thumbnail_between_slices(folder):
    """tifffile: a page of another size in the middle is named and left out."""
    path = folder / "a.tif"
    values = phantom()
    with tifffile.TiffWriter(path) as writer:
        for index, page in enumerate(values):
            writer.write(page, metadata=None, contiguous=False)
            if index == 1:
                writer.write(phantom(9, (3, 3)), metadata=None, contiguous=False)
    with tifffile.TiffFile(path) as file:
        others = [page.asarray() for page in file.pages if page.shape == (5, 6)]
    agree(path, in_millimetres(numpy.array(others)), "Pages of another size")


def stack_of_metamorph_with_heights(folder):
    """tifffile: five planes behind one directory, downwards at heights that the second tag states."""
    values = phantom(shape=(5, 6, 8))
    count, tags = len(values), 11
    places = 8 + 2 + 12 * tags + 4
    heights = b"".join(struct.pack("<6I", 20000 - 1500 * z, 1000, 2460310, 3600000, 2460310, 3600000)
                       for z in range(count))
    pixels = places + len(heights) + 8 * count + 48
    sizes = pixels - 48
    unit = b"\x02\0\0\0um" + bytes(2)
    calibration = struct.pack("<8I", 3, 1, 4, sizes + 40, 5, sizes + 40, 6, sizes + 32)
    assert len(calibration) == 32
    entries = [(256, 3, 1, 8), (257, 3, 1, 6), (258, 3, 1, 16), (259, 3, 1, 1), (262, 3, 1, 1),
               (273, 4, 1, pixels), (277, 3, 1, 1), (278, 3, 1, 6), (279, 4, 1, 96),
               (33628, 4, 4, sizes), (33629, 5, count, places)]
    path = folder / "a.stk"
    path.write_bytes(
        struct.pack("<2sHI", b"II", 42, 8) + struct.pack("<H", tags)
        + b"".join(struct.pack("<HHII", *entry) for entry in entries) + bytes(4)
        + heights + bytes(8 * count) + calibration + unit
        + struct.pack("<2I", 325, 1000) + values.tobytes())
    with tifffile.TiffFile(path) as file:
        stored, tags = file.series[0].asarray(), file.stk_metadata
    assert stored.shape == (5, 6, 8) and numpy.isclose(tags["XCalibration"], 0.325), tags
    steps = numpy.diff(tags["ZDistance"])
    agree(path, in_micrometres(stored, 0.325, 0.325, abs(float(numpy.mean(steps)))))


# Electron microscopes.


def mrc_volumes_with_an_origin(folder):
    """mrcfile: a stack of three volumes of floats, whose voxels are not cubes."""
    path = folder / "a.mrc"
    with mrcfile.new(path) as file:
        file.set_data(phantom(shape=(3, 4, 5, 6), kind="f4") / 3)
        file.voxel_size = (2.0, 3.0, 4.0)
        file.header.origin = (10, -20, 30)
    with mrcfile.open(path) as file:
        assert file.is_volume_stack()
        size, origin = file.voxel_size.tolist(), file.header.origin.tolist()
        others = [Volume(one, affine_of(numpy.array(size) * ANGSTROM, numpy.array(origin) * ANGSTROM))
                  for one in file.data]
    agree(path, others, "which side is the patient's left", times=[0, 1, 2])


def mrc_particles_are_no_volume(folder):
    """mrcfile: a stack of images in signed bytes, which a warning calls so."""
    path = folder / "a.mrcs"
    with mrcfile.new(path) as file:
        file.set_data(phantom(kind="i2").astype("i1"))
        file.set_image_stack()
        file.voxel_size = 2.0
    with mrcfile.open(path) as file:
        assert file.is_image_stack()
        other = Volume(file.data, affine_of(numpy.full(3, 2 * ANGSTROM), (0, 0, 0)))
    agree(path, other, "stack of 4 images")


def ccp4_map_that_begins_at_an_index(folder):
    """mrcfile: sections along x, a first index instead of an origin, unsigned shorts."""
    path = folder / "a.map"
    with mrcfile.new(path) as file:
        file.set_data(phantom())
        file.voxel_size = 2.0
        for name, value in {"mapc": 3, "mapr": 2, "maps": 1, "nxstart": 5, "nystart": -3, "nzstart": 1,
                            "mx": 4, "my": 5, "mz": 6}.items():
            file.header[name] = value
        file.header.cella = (4 * 1.5, 5 * 2.0, 6 * 2.5)
    with mrcfile.open(path, permissive=True) as file:
        starts = [int(file.header[f"n{axis}start"]) for axis in "xyz"]
        edges = [float(file.header.cella[axis]) / int(file.header[f"m{axis}"]) for axis in "xyz"]
        along = [int(file.header[name]) - 1 for name in ("mapc", "mapr", "maps")]
        columns = numpy.zeros((3, 3))
        for axis, cell in enumerate(along):
            columns[cell, axis] = edges[cell] * ANGSTROM
        other = Volume(file.data, affine_of((1, 1, 1), columns @ starts, columns))
    agree(path, other)


def mrc_of_half_floats_is_refused(folder):
    """mrcfile: mode 12 has floats of 16 bits."""
    path = folder / "a.mrc"
    with mrcfile.new(path) as file:
        file.set_data(phantom(kind="f2"))
        assert file.header.mode == 12
    refused(path, "the mode 12")


# NumPy.


def arrays_in_the_order_of_fortran(folder):
    """NumPy: four axes in big endian, whose first runs fastest and counts times."""
    path = folder / "a.npy"
    numpy.save(path, numpy.asfortranarray(phantom(shape=(3, 4, 5, 6), kind=">i4")))
    agree(path, [in_millimetres(one) for one in numpy.load(path)], "1 mm", times=[0, 1, 2])


def first_array_of_a_compressed_archive(folder):
    """NumPy: the first of two arrays, of truth values."""
    path = folder / "a.npz"
    numpy.savez_compressed(path, mask=phantom() > 500, scan=phantom(1))
    agree(path, in_millimetres(numpy.load(path)["mask"]))


def complex_numbers_of_numpy_are_refused(folder):
    """NumPy: the phase of complex numbers would be lost."""
    numpy.save(folder / "a.npy", phantom() * 1j)
    refused(folder / "a.npy", "the type \"c16\"")


if __name__ == "__main__":
    run(globals())
