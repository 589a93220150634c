"""Helpers of the tests of volumes in chunks and levels."""

import subprocess
import sys
import warnings

import numpy
import varimarch

TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


def values_of(shape=(7, 9, 11), kind="i2", seed=1):
    """Values that differ from voxel to voxel, and have all bytes of their type."""
    bits = numpy.random.default_rng(seed).integers(0, 2**52, shape, numpy.uint64)
    return bits.astype("f8").astype(kind) if kind[0] == "f" else (bits * 4096).astype(kind) + bits.astype(kind)


def read(path, **choices):
    """The values of a volume, its image, and the warnings of its reader."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        image = varimarch.read(path, **choices)
    return varimarch.to_array(image), image, [str(one.message) for one in caught]


def expect_refused(path, *words, **choices):
    """Requires one sentence that has all words."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            varimarch.read(path, **choices)
    except OSError as error:
        text = str(error)
        assert text.count(": expected ") == 1 and ", found " in text and "\n" not in text, text
        assert all(word in text for word in words), (words, text)
        return
    raise AssertionError(f"{path} was read instead of refused for {words}")


def run(*arguments, code=0):
    """The messages of a run of the program."""
    done = subprocess.run([sys.argv[2], *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == code, (arguments, done)
    return done.stderr
