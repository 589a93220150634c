#!/usr/bin/env python3
"""Volumes over the first one in images of the Python package.

Usage: test_overlays.py CASE VARIMARCH
"""

import sys

import numpy

import varimarch

from test_python import WHITE


def overlays_are_drawn_with_their_volume():
    """A volume over itself is twice as dense, and a place moves it."""
    array = numpy.full((16, 16, 16), 100, numpy.int16)
    array[:, :, :2] = 0
    fog = {"color": "white", "opacity": [(50, 0), (100, 0.02)]}
    look = {**WHITE, **fog, "shade": False, "parallel": True, "background": "black"}
    once = varimarch.render(array, **look)
    twice = varimarch.render(array, overlays=[{"volume": array, **fog}], **look)
    dense = varimarch.render(array, opacity_unit_distance=0.5, **look)
    difference = numpy.abs(twice.astype(int) - dense)
    assert difference.max() <= 4, difference.max()
    assert numpy.abs(twice.astype(int) - once).max() > 30
    red = {"volume": array, "color": "red", "opacity": [(50, 0), (100, 0.5)]}
    moved = varimarch.render(array, overlays=[{**red, "move": (0, 0, 100)}], **look)
    middle = once.shape[0] // 2
    assert numpy.abs(moved[middle].astype(int) - once[middle]).max() <= 4
    hidden = varimarch.render(array, overlays=[{**red, "strength": 0}], **look)
    assert numpy.abs(hidden.astype(int) - once).max() <= 4
    for arguments, words in (
        ({"overlays": [array] * 4}, "expected at most 3, found 4"),
        ({"overlays": [{"colour": "red"}]}, "found 'colour'"),
        ({"overlays": [{"color": "red"}]}, 'expected the key "volume"'),
        ({"overlays": [{"volume": array, "move": 3}]}, "move: expected three finite numbers"),
        ({"overlays": [array], "blend": "maximum"}, 'expected blend="composite"'),
    ):
        try:
            varimarch.render(array, **{**look, **arguments})
            raise AssertionError(f"{arguments} was accepted")
        except ValueError as error:
            assert words in str(error), error


def overlays_take_light_from_their_volume():
    """A block beside a volume darkens it, by a shadow and by what it hides of all around."""
    array = numpy.full((16, 16, 16), 100, numpy.int16)
    array[[0, -1]] = array[:, [0, -1]] = array[:, :, [0, -1]] = 0
    look = {"color": "white", "opacity": [(50, 0), (100, 0.5)]}
    # The block is at the patient's left, on the right of the image, and outside of it.
    beside = [{"volume": array, **look, "move": (16, 0, 0)}]
    for light in (
        {"lights": [{"kind": "camera", "direction": (1, 0, 0.5)}], "shadows": True},
        {"occlusion": 1, "occlusion_reach": 12},
    ):
        for arguments in ({}, light):
            scene = {**WHITE, **look, "shade": True, "parallel": True, **arguments}
            scene["lights"] = light.get("lights", [{"kind": "head"}])
            alone = varimarch.render(array, **scene)
            both = varimarch.render(array, overlays=beside, **scene)
            middle = alone.shape[1] // 2
            far = both[:, :middle].mean() / alone[:, :middle].mean()
            near = both[:, middle:].mean() / alone[:, middle:].mean()
            assert abs(far - 1) < 0.01, (arguments, far)
            if arguments:
                assert near < 0.95, (arguments, near)
            else:
                assert abs(near - 1) < 0.01, near


if __name__ == "__main__":
    globals()[sys.argv[1]]()
