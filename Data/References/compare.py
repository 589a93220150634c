#!/usr/bin/env python3
"""Compares images of the scenes in this folder with their references.

Usage: compare.py PICTURES [--json]

PICTURES is a folder with an image NAME.npy of each NAME.json here: floats, height x width x 4, the
top row first, premultiplied red, green, blue and opacity from 0 to 1, without a background. Errors
are in 1/255. Exit code 1: an image is missing, or has another size. Needs numpy, nothing else.
"""

import argparse
import json
import pathlib
import sys

import numpy

REFERENCES = pathlib.Path(__file__).resolve().parent


def error_of(picture, reference):
    """RMSE over all channels, 99.9th percentile over the pixels' worst channels, and the largest."""
    difference = 255.0 * numpy.abs(picture.astype(float) - reference)
    # A value that is not finite cannot be overlooked.
    difference = numpy.where(numpy.isfinite(difference), difference, numpy.inf)
    pixels = numpy.sort(difference.max(axis=2).ravel())
    accepted = pixels[int(numpy.ceil(0.999 * len(pixels))) - 1]
    return (difference**2).mean() ** 0.5, accepted, pixels[-1]


def compare(pictures):
    """A row for each scene, and sentences about images that cannot be compared."""
    rows, faults = [], []
    for description in sorted(REFERENCES.glob("*.json")):
        scene = json.loads(description.read_text())
        path = pictures / scene["image"]
        reference = numpy.load(REFERENCES / scene["image"])
        if not path.exists():
            faults.append(f"{path}: no such file; expected an image of {description.stem}")
            continue
        picture = numpy.load(path)
        if picture.shape != reference.shape:
            faults.append(f"{path}: found {picture.shape}, expected {reference.shape}")
            continue
        rmse, accepted, largest = error_of(picture, reference)
        rows.append({"scene": description.stem, "rmse": rmse, "percentile_99_9": accepted,
                     "largest": largest, "reference_error": scene["largestError"]})
    return rows, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pictures", type=pathlib.Path)
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    arguments = parser.parse_args()
    rows, faults = compare(arguments.pictures)
    if arguments.json:
        print(json.dumps(rows, indent=1))
    else:
        print("| scene | RMSE | 99.9 % of the pixels | largest | the reference's own error |")
        print("|---|---:|---:|---:|---:|")
        for row in rows:
            print(f"| {row['scene']} | {row['rmse']:.3f} | {row['percentile_99_9']:.3f} "
                  f"| {row['largest']:.3f} | {255 * row['reference_error']:.1e} |")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


sys.exit(main())
