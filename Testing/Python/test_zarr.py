#!/usr/bin/env python3
"""Volumes of OME-Zarr and Zarr, which zarr-python writes and reads.

Usage: test_zarr.py CASE VARIMARCH
"""

import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

import numcodecs
import numpy
import varimarch
import zarr

from pyramid_reading import TYPES, expect_refused, read, run, values_of


def write_zarr(path, values, **options):
    """An array of Zarr with the values."""
    options = {"chunks": values.shape, "dtype": values.dtype, **options}
    zarr.open_array(str(path), mode="w", shape=values.shape, **options)[:] = values


def describe(folder, axes, transforms, **more):
    """Writes metadata of OME-Zarr 0.4 with a pair of scale and translation for each level."""
    kinds = {"t": "time", "c": "channel"}
    entries = [{"name": name, "type": kinds.get(name, "space"), "unit": "micrometer"}
               if name in "xyz" else {"name": name, "type": kinds[name]} for name in axes]
    datasets = [{"path": str(level), "coordinateTransformations": [
        {"type": "scale", "scale": list(scale)},
        {"type": "translation", "translation": list(translation)}]}
        for level, (scale, translation) in enumerate(transforms)]
    (folder / ".zgroup").write_text('{"zarr_format": 2}')
    (folder / ".zattrs").write_text(json.dumps(
        {"multiscales": [{"version": "0.4", "axes": entries, "datasets": datasets}], **more}))


UNIT = ((1.0,) * 3, (0.0,) * 3)


def zarr_arrays_have_the_values_of_zarr_python(folder):
    """Every type, byte order, order of indices, separator, compression and shape of chunks."""
    blosc = numcodecs.Blosc
    codecs = [None, numcodecs.Zlib(1), numcodecs.GZip(1), numcodecs.BZ2(1), numcodecs.Zstd(1),
              numcodecs.LZ4(1), numcodecs.LZMA()]
    codecs += [blosc(name, 5, shuffle) for name, shuffle in itertools.product(
        ("lz4", "lz4hc", "zlib", "zstd", "blosclz"),
        (blosc.NOSHUFFLE, blosc.SHUFFLE, blosc.BITSHUFFLE))]
    shapes = ((3, 4, 5), (7, 9, 11), (2, 16, 3))
    cases = itertools.cycle(itertools.product("<>", "CF", "./", shapes))
    kinds = itertools.product((None, blosc("zstd", 5, blosc.SHUFFLE)), TYPES)
    pairs = [*kinds, *((codec, "u2") for codec in codecs)]
    for number, (codec, kind) in enumerate(pairs):
        first, order, separator, chunks = next(cases)
        values = values_of(kind=kind, seed=number)
        path = folder / f"{number}.zarr"
        write_zarr(path, values, chunks=chunks, order=order, dtype=first + kind,
                   compressor=codec, dimension_separator=separator)
        found, image, doubts = read(path)
        expected = values if order == "C" else values.T
        assert found.dtype == numpy.dtype(kind), (found.dtype, kind)
        assert (found == expected).all(), (kind, codec, first, order, separator, chunks)
        assert any("1 mm" in doubt for doubt in doubts), doubts


def zarr_axes_lie_where_their_names_say(folder):
    """All orders and directions of the axes, with units, scales and translations."""
    values = values_of((3, 4, 5))
    spacing = {"x": 0.5, "y": 2.0, "z": 3.0}
    origin = {"x": -7.0, "y": 11.0, "z": 13.0}
    path = folder / "a.zarr"
    for order in "CF":
        write_zarr(path / "0", values, order=order, chunks=(2, 2, 2))
        for axes, signs in itertools.product(
                itertools.permutations("xyz"), itertools.product((1, -1), repeat=3)):
            scale = [sign * spacing[axis] for sign, axis in zip(signs, axes)]
            describe(path, axes, [(scale, [origin[axis] for axis in axes])])
            found, image, _ = read(path)
            assert ((found if order == "C" else found.T) == values).all()
            place = [0.0] * 3
            # The element [1, 2, 3] of the array.
            image.TransformIndexToPhysicalPoint(*((3, 2, 1) if order == "C" else (1, 2, 3)), place)
            for world, axis in enumerate("xyz"):
                number = axes.index(axis)
                expected = 1e-3 * (origin[axis] + scale[number] * (number + 1))
                assert abs(place[world] - expected) < 1e-9, (order, axes, signs, place)


def named_axes(path, values, names, attributes=None):
    """An array of Zarr with the names that xarray gives to its axes."""
    write_zarr(path, values)
    (path / ".zattrs").write_text(json.dumps({"_ARRAY_DIMENSIONS": names, **(attributes or {})}))


def zarr_axes_have_the_names_of_xarray(folder):
    """Axes of space in any order, channels, times, and axes whose names mean nothing."""
    values = values_of((3, 4, 5))
    for names in itertools.permutations("xyz"):
        named_axes(folder / "a.zarr", values, names)
        found, image, doubts = read(folder / "a.zarr")
        assert (found == values).all()
        place = [0.0] * 3
        image.TransformIndexToPhysicalPoint(3, 2, 1, place)  # the element [1, 2, 3]
        assert place == [float(names.index(axis) + 1) for axis in "xyz"], (names, place)
        assert any("mirrored" in doubt for doubt in doubts), doubts
    named_axes(folder / "b.zarr", values, ["row", "Column", "channel"])
    found, image, doubts = read(folder / "b.zarr", channel=3)
    assert (found == values[None, :, :, 3]).all(), found.shape
    named_axes(folder / "c.zarr", values, ["section", "y", "x"])
    assert (read(folder / "c.zarr")[0] == values).all()
    named_axes(folder / "d.zarr", values, ["time", "y", "x"])
    assert (read(folder / "d.zarr", time=2)[0] == values[2][None]).all()
    assert len(varimarch.times(str(folder / "d.zarr"))) == 3
    named_axes(folder / "e.zarr", values, ["x", "y"])  # not as many as axes
    assert (read(folder / "e.zarr")[0] == values).all()


def zarr_groups_of_xarray_lie_at_their_coordinates(folder):
    """The largest array of a group, with its coordinates, units and the map of its values."""
    values = values_of((3, 4, 5))
    path = folder / "a.zarr"
    zarr.open_group(str(path), mode="w")
    coordinates = {"x": (-10 + 0.5 * numpy.arange(5), "mm"), "y": (7 - 2 * numpy.arange(4), "cm"),
                   "z": (numpy.array((1.0, 2.0, 5.0)), "mm")}
    for name, (places, unit) in coordinates.items():
        named_axes(path / name, places, [name], {"units": unit})
    named_axes(path / "ct", values, ["z", "y", "x"], {"scale_factor": 0.5, "add_offset": 3})
    named_axes(path / "small", values[:2], ["z", "y", "x"])
    named_axes(path / "words", numpy.array(["a", "b"]), ["word"])
    found, image, doubts = read(path)
    assert (found == values).all()
    place = [0.0] * 3
    image.TransformIndexToPhysicalPoint(1, 1, 1, place)
    assert numpy.allclose(place, (-9.5, 50.0, 3.0)), place
    for words in ('"ct"', "evenly", "0.5 times", "mirrored"):
        assert any(words in doubt for doubt in doubts), (words, doubts)
    assert not any("1 mm" in doubt for doubt in doubts), doubts
    assert (read(path / "small")[0] == values[:2]).all()
    (path / "x" / "0").write_bytes(b"damaged")
    expect_refused(path, "x/0")
    named_axes(path / "x", numpy.arange(4.0), ["x"])  # not as many as voxels
    assert any("1 mm" in doubt for doubt in read(path)[2])


def zarr_sides_are_those_of_its_orientations(folder):
    """The orientations of RFC-4; the sides of others, and of images that lack some, are unknown."""
    values = values_of((3, 4, 5))
    path = folder / "a.zarr"
    write_zarr(path / "0", values)
    lps = {"right-to-left": (0, 1), "left-to-right": (0, -1), "anterior-to-posterior": (1, 1),
           "posterior-to-anterior": (1, -1), "inferior-to-superior": (2, 1),
           "superior-to-inferior": (2, -1)}

    def orient(texts):
        describe(path, "zyx", [((3.0, 2.0, 1.0), (30.0, 20.0, 10.0))])
        attributes = json.loads((path / ".zattrs").read_text())
        for axis, text in zip(attributes["multiscales"][0]["axes"], texts):
            axis.update({"orientation": {"type": "anatomical", "value": text}, "unit": "millimeter"})
        (path / ".zattrs").write_text(json.dumps(attributes))
        return read(path)

    for texts in itertools.permutations(lps, 3):
        worlds = [lps[text][0] for text in texts]
        found, image, doubts = orient(texts)
        assert (found == values).all()
        assert any("mirrored" in doubt for doubt in doubts) == (len(set(worlds)) < 3), (texts, doubts)
        if len(set(worlds)) == 3:
            place = [0.0] * 3
            image.TransformIndexToPhysicalPoint(3, 2, 1, place)
            expected = {lps[text][0]: lps[text][1] * where
                        for text, where in zip(texts, (33.0, 24.0, 13.0))}
            assert numpy.allclose(place, [expected[world] for world in range(3)]), (texts, place)
    assert any("mirrored" in doubt for doubt in orient(("dorsal-to-ventral", *list(lps)[:2]))[2])


def zarr_opens_by_any_of_its_names(folder):
    """A folder, its metadata, an array in it, a ZIP archive of it, and several images in one."""
    values = values_of((5, 6, 7))
    path = folder / "brain.zarr"
    write_zarr(path / "0", values, chunks=(4, 4, 4))
    describe(path, "zyx", [UNIT])
    for name in (path, path / ".zattrs", path / "0", path / "0" / ".zarray"):
        assert (read(name)[0] == values).all(), name
    subprocess.run([sys.executable, "-m", "zipfile", "-c", "brain.zip", "brain.zarr"],
                   cwd=folder, check=True)
    assert (read(folder / "brain.zip")[0] == values).all()
    several = folder / "several.zarr"
    several.mkdir()
    path.rename(several / "0")
    (several / ".zattrs").write_text('{"bioformats2raw.layout": 3}')
    assert (read(several)[0] == values).all()
    (several / ".zattrs").write_text("{}")
    expect_refused(several, '"0"')


def zarr_levels_channels_and_times_are_chosen(folder):
    """The level, channel and time that are asked for; what is left out is named."""
    path = folder / "a.zarr"
    values = values_of((2, 3, 4, 6, 8), "u2")
    half = values[..., ::2, ::2, ::2]
    for level, array in enumerate((values, half)):
        write_zarr(path / str(level), array, chunks=(1, 2, 3, 3, 3))
    window = {"window": {"start": 10, "end": 30, "min": 0, "max": 99}}
    describe(path, "tczyx", [((1.0, 1.0, 2.0 * f, 3.0 * f, 4.0 * f), (0.0,) * 5) for f in (1, 2)],
             omero={"channels": [{**window, "label": name, "color": color} for name, color in
                                 (("DAPI", "0000FF"), ("GFP", "00ff00"), ("", "FF8000"))]})
    found, image, doubts = read(path)
    assert (found == values[0, 0]).all()
    assert sum("counted from 0" in doubt for doubt in doubts) == 1, doubts
    assert sum("2 times" in doubt for doubt in doubts) == 1, doubts
    found, image, _ = read(path, level=1, channel=2, time=1)
    assert (found == half[1, 2]).all()
    assert numpy.allclose(image.GetSpacing(), (8e-3, 6e-3, 4e-3))
    found, image, doubts = read(path, channel="all", time=1)
    assert (found == numpy.moveaxis(values[1], 0, -1)).all()
    assert not any("counted from 0" in doubt for doubt in doubts), doubts
    names = [image.GetPointData().GetScalars().GetComponentName(i) for i in range(3)]
    assert names == ["DAPI", "GFP", "Channel 3"], names
    assert image.GetFieldData().GetArray("ChannelColors").GetTuple3(0) == (0.0, 0.0, 1.0)
    expect_refused(path, "level from 0 to 1", level=2)
    expect_refused(path, "channel from 0 to 2", channel=3)
    expect_refused(path, "time from 0 to 1", time=2)
    reader = varimarch.vtkVolumeFileReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert (reader.GetWindow(), reader.GetLevel()) == (20.0, 20.0)
    run("info", path, "--level", 1, "--channel", 2, "--json", folder / "info.json")
    assert json.loads((folder / "info.json").read_text())["volume"]["dimensions"] == [4, 3, 2]


def the_finest_level_that_fits_is_read(folder):
    """An array of 4 PB without a chunk, and a level that fits."""
    path = folder / "a.zarr"
    zarr.open_array(str(path / "0"), mode="w", shape=(2**17,) * 3, chunks=(64,) * 3, dtype="u2")
    values = values_of((8, 8, 8), "u2")
    write_zarr(path / "1", values)
    describe(path, "zyx", [UNIT, ((16384.0,) * 3, (0.0,) * 3)])
    found, _, doubts = read(path)
    assert (found == values).all()
    assert any("Level 1" in doubt for doubt in doubts), doubts
    expect_refused(path, "in the memory of", level=0)


def missing_chunks_have_the_fill_value(folder):
    """Chunks without a file, and how many there are."""
    fills = (("u1", 255), ("i2", -3), ("f4", numpy.nan), ("f8", numpy.inf), ("f8", -numpy.inf))
    for number, (kind, fill) in enumerate(fills):
        path = folder / f"{number}.zarr"
        array = zarr.open_array(str(path), mode="w", shape=(6, 6, 6), chunks=(3, 3, 3),
                                dtype=kind, fill_value=fill)
        array[:3, :3, :3] = 1
        found, _, doubts = read(path)
        assert numpy.array_equal(found, array[:], equal_nan=kind[0] == "f")
        assert any("7 chunks" in doubt for doubt in doubts), doubts
        assert "Chunks are missing" in run("convert", path, folder / f"copy-{number}.zarr")


def forged_zarr_is_one_sentence(folder):
    """Descriptions that nothing can be, and those of what is not read."""
    path = folder / "bad.zarr"
    values = values_of((4, 5, 6))
    write_zarr(path, values, compressor=None)
    good = json.loads((path / ".zarray").read_text())
    for words, changes in (
        ("version 2", {"zarr_format": 3}),
        ("in the memory of", {"shape": [2**20] * 3}),
        ("2147483647", {"shape": [2**62] * 3}),
        ("whole numbers", {"shape": [2**70, 1, 1]}),
        ("whole numbers", {"shape": [0, 5, 6]}),
        ("whole numbers", {"shape": [-4, 5, 6]}),
        ("whole numbers", {"shape": "large"}),
        ("whole numbers", {"chunks": [1.5, 2, 2]}),
        ("chunks that fit", {"chunks": [2**14, 2**13, 2**13]}),
        ("chunks that fit", {"chunks": [2**62, 2**62, 2**62], "dimension_separator": "/"}),
        ("chunks of 3 axes", {"chunks": [4, 5]}),
        ("<f2", {"dtype": "<f2"}),
        ("dtype", {"dtype": [["a", "<i2"]]}),
        ("fill_value", {"fill_value": "a"}),
        ("fill_value", {"fill_value": 1e9}),
        ("order", {"order": "K"}),
        ("dimension_separator", {"dimension_separator": "x"}),
        ("delta", {"filters": [{"id": "delta"}]}),
        ("zfpy", {"compressor": {"id": "zfpy"}}),
    ):
        (path / ".zarray").write_text(json.dumps({**good, **changes}))
        expect_refused(path, words)
    (path / ".zarray").unlink()
    (path / "zarr.json").write_text('{"zarr_format": 3}')
    expect_refused(path, "version 3")


def cut_zarr_is_one_sentence(folder):
    """Chunks and descriptions that end early, and levels that are missing."""
    values = values_of((4, 5, 6))
    path = folder / "cut.zarr"
    for codec in (None, numcodecs.Zlib(1), numcodecs.GZip(1), numcodecs.BZ2(1), numcodecs.Zstd(1),
                  numcodecs.LZ4(1), numcodecs.Blosc("zstd")):
        write_zarr(path, values, compressor=codec)
        whole = (path / "0.0.0").read_bytes()
        for size in (0, 1, 5, len(whole) // 2, len(whole) - 1):
            (path / "0.0.0").write_bytes(whole[:size])
            expect_refused(path, "0.0.0")
    text = (path / ".zarray").read_text()
    for size in range(0, len(text) - 2, 9):
        (path / ".zarray").write_text(text[:size])
        expect_refused(path)
    image = folder / "image.zarr"
    write_zarr(image / "0", values)
    describe(image, "zyx", [UNIT, UNIT])
    expect_refused(image, "1/.zarray")
    describe(image, "zyx", [((0.0, 1.0, 1.0), (0.0,) * 3)])
    expect_refused(image, "size above 0")
    describe(image, "cyx", [UNIT])
    expect_refused(image / ".zattrs", "channel", channel=9)
    describe(image, "zyx", [UNIT])
    expect_refused(image, "channel", channel=1)
    numpy.save(folder / "a.npy", values)
    expect_refused(folder / "a.npy", "NumPy", level=1)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
