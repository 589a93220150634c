#!/usr/bin/env python3
"""Volumes that `varimarch convert` writes in OME-Zarr, which zarr-python reads.

Usage: test_zarr_writing.py CASE VARIMARCH
"""

import itertools
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import numpy
import zarr

from pyramid_reading import read, run, values_of


def written_pyramids_are_read_by_zarr_python(folder):
    """Levels of means with their places; and the same of a volume that is read in chunks."""
    for kind in ("u1", "i2", "f4"):
        values = values_of((65, 70, 130), "u1").astype(kind) - (kind != "u1")
        numpy.save(folder / "a.npy", values)
        target = folder / f"{kind}.zarr"
        run("convert", folder / "a.npy", target)
        group = zarr.open_group(str(target), mode="r")
        assert len(group.attrs["multiscales"][0]["datasets"]) == 3
        assert (group["0"][:] == values).all() and group["0"].dtype == values.dtype
        assert group["1"].shape == (33, 35, 65) and group["2"].shape == (33, 35, 33)
        padded = numpy.pad(values.astype("f8"), ((0, 1), (0, 0), (0, 0)), constant_values=numpy.nan)
        mean = numpy.nanmean(padded.reshape(33, 2, 35, 2, 65, 2), axis=(1, 3, 5))
        expected = mean if kind == "f4" else numpy.floor(mean + 0.5)
        assert numpy.allclose(group["1"][:], expected, rtol=1e-6), kind
        for level, (spacing, origin) in enumerate(
                (((1.0,) * 3, (0.0,) * 3), ((2.0,) * 3, (0.5,) * 3), ((4.0, 2.0, 2.0), (1.5, 0.5, 0.5)))):
            found, image, _ = read(target, level=level)
            assert (found == group[str(level)][:]).all()
            assert numpy.allclose(image.GetSpacing(), spacing), level
            assert numpy.allclose(image.GetOrigin(), origin), level
        copy = folder / f"{kind}-copy.zarr"
        assert "missing" not in run("convert", target, copy)
        again = zarr.open_group(str(copy), mode="r")
        assert all((group[level][:] == again[level][:]).all() for level in "012")


def written_pyramids_have_components_as_channels(folder):
    """Colours become channels."""
    values = values_of((5, 6, 7, 3), "u1")
    numpy.save(folder / "a.npy", values)
    run("convert", folder / "a.npy", folder / "a.zarr")
    assert (zarr.open(str(folder / "a.zarr"), mode="r")["0"][:] == numpy.moveaxis(values, 3, 0)).all()
    assert (read(folder / "a.zarr", channel=2)[0] == values[..., 2]).all()


def written_pyramids_replace_nothing_else(folder):
    """An existing folder stays unless told, and one that is no Zarr always; nothing is left over."""
    target = folder / "a.zarr"
    volume = "procedural:shells:20x20x20"
    run("convert", volume, target)
    assert "--overwrite" in run("convert", volume, target, code=1)
    run("convert", "procedural:shells:30x20x20", target, "--overwrite")
    assert zarr.open_group(str(target), mode="r")["0"].shape == (20, 20, 30)
    other = folder / "b.zarr"
    other.mkdir()
    (other / "letter.txt").write_text("dear")
    run("convert", volume, other, "--overwrite", code=1)
    assert (other / "letter.txt").exists()
    assert sorted(path.name for path in folder.iterdir()) == ["a.zarr", "b.zarr"]
    turned = folder / "turned.nrrd"
    turned.write_bytes(b"NRRD0004\ntype: uint8\ndimension: 3\nspace: LPS\nsizes: 2 2 2\n"
                       b"space directions: (0,1,0) (-1,0,0) (0,0,1)\nspace origin: (0,0,0)\n"
                       b"encoding: raw\n\n" + bytes(8))
    assert "directions" not in run("convert", turned, folder / "turned.zarr")
    oblique = turned.read_bytes().replace(b"(0,1,0) (-1,0,0)", b"(0.6,0.8,0) (-0.8,0.6,0)")
    turned.write_bytes(oblique)
    assert "no oblique directions" in run("convert", turned, folder / "oblique.zarr")


def written_pyramids_keep_sides_and_places(folder):
    """Orders and directions of axes along those of the patient are read where they were."""
    values = values_of((3, 4, 5))
    spacing = (0.5, 2.0, 3.0)
    cases = itertools.product(
        itertools.permutations(range(3)), itertools.product((1, -1), repeat=3))
    for order, signs in list(cases)[::5]:
        directions = numpy.zeros((3, 3))
        for axis in range(3):
            directions[axis, order[axis]] = signs[axis] * spacing[axis]
        rows = " ".join(f"({','.join(str(number) for number in row)})" for row in directions)
        source = folder / "a.nrrd"
        source.write_bytes(
            f"NRRD0004\ntype: int16\nendian: little\ndimension: 3\nspace: LPS\nsizes: 5 4 3\n"
            f"space directions: {rows}\nspace origin: (7,-8,9)\nencoding: raw\n\n".encode()
            + values.astype("<i2").tobytes())
        target = folder / "a.zarr"
        assert "warning" not in run("convert", source, target, "--overwrite")
        found, image, doubts = read(target)
        assert not any("mirrored" in doubt for doubt in doubts), doubts
        for index in itertools.product((0, 4), (0, 3), (0, 2)):
            place = numpy.array((7.0, -8.0, 9.0)) + numpy.array(index) @ directions
            back = [0.0] * 3
            image.TransformPhysicalPointToContinuousIndex(place, back)
            i, j, k = (int(round(number)) for number in back)
            assert numpy.allclose(back, (i, j, k), atol=1e-6), (order, signs, back)
            assert found[k, j, i] == values[index[2], index[1], index[0]], (order, signs, index)
        again = folder / "again.zarr"
        run("convert", target, again, "--overwrite")
        assert (read(again)[0] == found).all() and read(again)[1].GetOrigin() == image.GetOrigin()


def written_pyramids_leave_nothing_behind(folder):
    """An interrupt deletes the unfinished folder; after a kill, the next run does."""
    for signal_number, left in ((signal.SIGTERM, 0), (signal.SIGKILL, 1)):
        writing = subprocess.Popen(
            [sys.argv[2], "convert", "procedural:shells:400x400x400", folder / "a.zarr"],
            stderr=subprocess.DEVNULL)
        while not list(folder.glob("*.part.zarr/0/0")):
            assert writing.poll() is None, "it ended before it was stopped"
            time.sleep(0.01)
        writing.send_signal(signal_number)
        assert writing.wait() == -signal_number
        assert len(list(folder.iterdir())) == left, list(folder.iterdir())
    run("convert", "procedural:shells:20x20x20", folder / "b.zarr")
    assert [path.name for path in folder.iterdir()] == ["b.zarr"]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
