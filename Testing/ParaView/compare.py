#!/usr/bin/env python3
"""Compares pictures of ParaView.

Usage: compare.py FIRST SECOND [LEAST]   the peak signal to noise ratio [dB] of two PNG files, or of two
                                         files of floats
       compare.py --reference NAME FILE MOST
                                         the RMSE [1/255] of a file to NAME of Data/References

The exit code is 1 if the ratio is below LEAST, if the first picture is dark, or if the error is above
MOST.
"""

import math
import pathlib
import sys

import numpy
from PIL import Image

REFERENCES = pathlib.Path(__file__).resolve().parents[2] / "Data" / "References"


def pixels(path):
    """The colours of a file, 0 to 255; those of floats are limited to these, as those of a PNG are."""
    if path.endswith(".floats"):
        colors = numpy.fromfile(path, numpy.float32).reshape(-1, 4)[:, :3]
        return 255.0 * numpy.clip(colors.astype(float), 0.0, 1.0)
    return numpy.asarray(Image.open(path).convert("RGB")).astype(float)


def rmse(first, second):
    return float(numpy.sqrt(((first - second) ** 2).mean()))


def main():
    if sys.argv[1] == "--reference":
        name, path, most = sys.argv[2:]
        # A pixel of 8 bits holds at most 255, also where light makes the exact one brighter.
        truth = numpy.minimum(255.0 * numpy.load(REFERENCES / f"{name}.npy")[:, :, :3], 255.0)
        error = rmse(pixels(path), truth)
        print(f"RMSE {error:.2f} of 255")
        return error > float(most)
    first, second = pixels(sys.argv[1]), pixels(sys.argv[2])
    error = rmse(first, second)
    decibels = 20.0 * math.log10(255.0 / error) if error else math.inf
    print(f"{decibels:.1f} dB, at most {abs(first - second).max():.0f}")
    # Two black pictures are alike, but show nothing.
    return first.max() < 100.0 or (len(sys.argv) > 3 and decibels < float(sys.argv[3]))


sys.exit(main())
