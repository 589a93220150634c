#!/usr/bin/env python3
"""Tests of fields that the Python package computes.

Usage: test_fields.py CASE VARIMARCH
"""

import pathlib
import sys
import tempfile

import numpy
import varimarch


def variation_fields_are_what_their_definition_says(folder):
    """The distance from each voxel to the nearest one that differs by the tolerance or more."""
    values = numpy.random.default_rng(3).integers(0, 4, (5, 6, 7)).astype(numpy.int16)
    places = numpy.stack(numpy.indices(values.shape), -1).reshape(-1, 3)
    apart = numpy.abs(places[:, None] - places)
    differs = numpy.abs(values.reshape(-1, 1) - values.reshape(-1)) >= 3
    for distance, far in (
        ("euclidean", numpy.sqrt((apart**2).sum(-1))),
        ("chebyshev", apart.max(-1)),
    ):
        expected = numpy.where(differs, far, 255).min(1).astype(numpy.uint8).reshape(values.shape)
        assert len(numpy.unique(expected)) > 2, "the volume tests nothing"
        field = varimarch.variation_field(values, 3, distance=distance)
        assert field.dtype == numpy.uint8 and (field == expected).all(), distance
    assert (varimarch.variation_field(values, 3) != varimarch.variation_field(values, 2)).any()
    image = varimarch.to_image(values, (1, 2, 3))
    assert (varimarch.variation_field(image, 3) == varimarch.variation_field(values, 3)).all()
    for wrong in ({"tolerance": -1}, {"tolerance": 1, "distance": "manhattan"}):
        try:
            varimarch.variation_field(values, **wrong)
            raise AssertionError(f"{wrong} is accepted")
        except ValueError as error:
            assert str(error).strip()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
