"""What the inputs of all families share: reading with varimarch, and comparing with another program.

An input is a function that takes an empty folder, makes files in it, and compares what varimarch
reads of them with what another program does. A volume is compared in the order of LPS, so that a
program may store its axes in any order and direction.
"""

import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import traceback
import warnings
from typing import NamedTuple

import numpy
import varimarch


class Volume(NamedTuple):
    """Values [z, y, x] or [z, y, x, component], and the matrix from (x, y, z) to LPS in mm."""

    values: numpy.ndarray
    affine: numpy.ndarray


def phantom(seed=0, shape=(4, 5, 6), kind="u2"):
    """Values from 0 to 1000 without a symmetry, so that mirrored or exchanged axes are noticed."""
    return numpy.random.default_rng(seed).integers(0, 1000, shape).astype(kind)


def affine_of(spacing=(0.7, 0.8, 2.5), origin=(-10.0, -20.0, 30.0), columns=numpy.eye(3)):
    """The matrix of a grid whose axes run along the columns of a matrix."""
    affine = numpy.eye(4)
    affine[:3, :3] = numpy.asarray(columns, float) * spacing
    affine[:3, 3] = origin
    return affine


def from_ras(affine):
    """A matrix in LPS for one in the RAS space of NIfTI, MGH, MINC and MIF."""
    return numpy.diag((-1.0, -1.0, 1.0, 1.0)) @ affine


def in_order_of_lps(volume):
    """The volume with its axes along L, P and S, as nearly as they allow."""
    values, affine = volume.values, numpy.array(volume.affine, float)
    order = [int(axis) for axis in numpy.argmax(abs(affine[:3, :3]), axis=0)]
    if sorted(order) == [0, 1, 2]:
        sources = [order.index(axis) for axis in range(3)]
        affine[:3, :3] = affine[:3, sources]
        rest = list(range(3, values.ndim))
        values = values.transpose([2 - sources[axis] for axis in (2, 1, 0)] + rest)
    for axis in range(3):
        if affine[numpy.argmax(abs(affine[:3, axis])), axis] < 0.0:
            values = numpy.flip(values, 2 - axis)
            affine[:3, 3] += affine[:3, axis] * (values.shape[2 - axis] - 1)
            affine[:3, axis] *= -1.0
    return Volume(values, affine)


def read(path, **options):
    """The volume that varimarch reads, and the warnings of its reader."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        image = varimarch.read(path, **options)
    matrix = image.GetDirectionMatrix()
    columns = [[matrix.GetElement(row, column) for column in range(3)] for row in range(3)]
    affine = affine_of(image.GetSpacing(), image.GetOrigin(), columns)
    return Volume(varimarch.to_array(image), affine), [str(one.message) for one in caught]


def compare(found, other):
    """Requires that two volumes are equal, up to rounding of floats of 32 bits."""
    found, other = in_order_of_lps(found), in_order_of_lps(other)
    assert found.values.shape == other.values.shape, (
        f"{found.values.shape} voxels instead of {other.values.shape}")
    largest = float(numpy.max(abs(other.values.astype(float)))) or 1.0
    off = numpy.max(abs(found.values.astype(float) - other.values.astype(float)))
    assert off <= 2e-6 * largest, (
        f"values off by {off:g}: {found.values.ravel()[:4]} instead of {other.values.ravel()[:4]}")
    assert numpy.allclose(found.affine, other.affine, atol=1e-4), (
        f"affine {found.affine[:3].round(4).tolist()} instead of {other.affine[:3].round(4).tolist()}")


def agree(path, others, *words, times=None, **options):
    """Requires that varimarch reads what another program does.

    others: the volume of the other program, or a list with one for each time.
    words: each must be in a warning.
    times: the seconds of the times, or their numbers where the file does not state any.
    """
    volumes = others if isinstance(others, list) else [others]
    if times is not None:
        stated = varimarch.times(path)
        assert len(stated) == len(times) and numpy.allclose(stated, times, atol=1e-4), (
            f"times {list(stated)} instead of {list(times)}")
    for time, other in enumerate(volumes):
        found, doubts = read(path, **({"time": time} if len(volumes) > 1 else {}), **options)
        compare(found, other)
        for word in words:
            assert any(word in doubt for doubt in doubts), f"no warning with {word!r}: {doubts}"


def refused(path, *words):
    """Requires one sentence about the file that has all words."""
    try:
        read(path)
    except OSError as error:
        text = str(error)
        assert ": expected " in text and ", found " in text and "\n" not in text, text
        assert all(word in text for word in words), (words, text)
        return
    raise AssertionError(f"{path} was read instead of refused for {words}")


def program(*arguments):
    """Runs the program varimarch, whose path is in the environment, and returns its messages."""
    done = subprocess.run([os.environ["VARIMARCH"], *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done
    return done.stderr


def run(inputs):
    """Runs all inputs of a family, or those that the command line names; lists all that disagree."""
    chosen = sys.argv[1:]
    mine = {name: function for name, function in inputs.items()
            if inspect.isfunction(function) and function.__module__ == "__main__"
            and list(inspect.signature(function).parameters) == ["folder"]
            and (not chosen or name in chosen)}
    wrong = 0
    for name, function in mine.items():
        with tempfile.TemporaryDirectory() as folder:
            try:
                function(pathlib.Path(folder))
            except AssertionError as error:
                wrong += 1
                print(f"{name}: {str(error) or traceback.format_exc()}")
            except Exception:  # pylint: disable=broad-except
                wrong += 1
                print(f"{name}: {traceback.format_exc()}")
    print(f"{len(mine)} inputs, of which {wrong} disagree.")
    sys.exit(1 if wrong or not mine else 0)
