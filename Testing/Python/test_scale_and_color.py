#!/usr/bin/env python3
"""Draws volumes of any size, of colours and of channels by the package varimarch, as a user does.

Usage: test_scale_and_color.py CASE
"""

import pathlib
import sys
import tempfile
import warnings

import numpy
import varimarch
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from nifti_files import nifti_of_times

warnings.simplefilter("error")

SMALL = {"size": (60, 60), "background": "black"}
PLACES = ((0.0, 0.0, -0.5), (0.0, 0.0, 0.5), (0.5, 0.0, 0.0))


def grid(side=32):
    return numpy.mgrid[-1 : 1 : side * 1j, -1 : 1 : side * 1j, -1 : 1 : side * 1j]


def ball(side=48):
    """A smooth ball, indexed [z, y, x]."""
    radius = numpy.sqrt((grid(side) ** 2).sum(axis=0))
    return (2000 / (1 + numpy.exp((radius - 0.6) * 30))).astype(numpy.uint16)


def blobs(scale=250, kind=numpy.uint8):
    """A blob in each of three components: at the left, at the right, and above."""
    z, y, x = grid()
    return numpy.stack(
        [
            (scale * numpy.exp(-8 * ((z - c) ** 2 + (y - b) ** 2 + (x - a) ** 2))).astype(kind)
            for c, b, a in PLACES
        ],
        axis=-1,
    )


def colours_at_blobs(picture):
    """The pixels where the three blobs are seen from the front, where x points to the right."""
    height, width, _ = picture.shape
    middle, right = width // 2, int(width * 0.17)
    return [
        picture[height // 2, middle - right].astype(int),
        picture[height // 2, middle + right].astype(int),
        picture[height // 2 - right, middle].astype(int),
    ]


def presets_draw_the_same_picture_at_any_scale(_folder):
    """A cube of 200 mm is as large as the body that relative lengths are for."""
    values = ball()
    hounsfield = values.astype(numpy.int16) - 1000
    for preset in varimarch.presets():
        given = hounsfield if preset.startswith("ct") else values
        look = {**SMALL, "preset": preset}
        look["background"] = "white" if preset == "pet-maximum" else "black"
        expected = varimarch.render(given, spacing=[200 / 48] * 3, **look)
        background = expected[0, 0].astype(int)
        assert abs(expected - background).max() > 60, preset
        for spacing in (2e-7, 2e-4, 1e-2, 1e3):
            picture = varimarch.render(given, spacing=[spacing] * 3, **look)
            difference = abs(picture.astype(int) - expected)
            assert difference.max() <= 6, (preset, spacing, difference.max())


def lengths_of_patients_are_millimetres(folder):
    """A file of a format for patients has the lengths of presets, whatever its size from 20 mm on."""
    values = ball().astype(numpy.int16)
    patient = varimarch.to_image(values, (1, 1, 1))
    anything = varimarch.to_image(values, (1, 1, 1))
    mark = numpy_to_vtk(numpy.ones(1, numpy.uint8), deep=True)
    mark.SetName("ShowsPatient")
    patient.GetFieldData().AddArray(mark)
    drawn = varimarch.render(patient, **SMALL)
    assert (drawn == varimarch.render(anything, opacity_unit_distance=1.0, **SMALL)).all()
    assert (drawn != varimarch.render(anything, **SMALL)).any()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        read = varimarch.read(nifti_of_times(folder / "one.nii", [0]))
    assert read.GetFieldData().HasArray("ShowsPatient")


def explicit_lengths_are_taken_as_they_are(_folder):
    values = ball()
    tiny = varimarch.render(values, spacing=[1e-3] * 3, opacity_unit_distance=1e-3, **SMALL)
    large = varimarch.render(values, spacing=[1] * 3, opacity_unit_distance=1, **SMALL)
    assert abs(tiny.astype(int) - large).max() <= 4


def colours_are_drawn_in_their_colours(_folder):
    for values in (blobs(), blobs(60000, numpy.uint16)):
        image = varimarch.to_image(values)
        for component, name in enumerate(("Red", "Green", "Blue")):
            image.GetPointData().GetScalars().SetComponentName(component, name)
        for preset in ("mr-head", "mr-t2"):
            picture = varimarch.render(image, preset=preset, view="anterior", shade=False, **SMALL)
            for component, pixel in enumerate(colours_at_blobs(picture)):
                others = [pixel[other] for other in range(3) if other != component]
                assert pixel[component] > 40 and max(others) < 0.5 * pixel[component], (preset, pixel)


def alpha_is_the_opacity_of_colours(_folder):
    """Only the half with alpha is seen; alpha that is the same everywhere says nothing."""
    values = numpy.full((24, 24, 24, 4), 255, numpy.uint8)
    values[:, :, :12, 3] = 0
    look = {"opacity": [(0, 0), (255, 1)], "view": "anterior", "shade": False, **SMALL}
    picture = varimarch.render(values, **look)
    assert picture[30, 45].min() > 200 and picture[30, 15].max() == 0
    opaque = numpy.concatenate((blobs(), numpy.full((32, 32, 32, 1), 255, numpy.uint8)), axis=-1)
    assert (varimarch.render(opaque, **SMALL) == varimarch.render(blobs(), **SMALL)).all()


def channels_have_a_function_each(_folder):
    values = blobs(1.0, numpy.float32) * numpy.array([100, 3000, 40], numpy.float32)
    look = {"view": "anterior", "shade": False, "preset": "mr-head", **SMALL}
    pixels = colours_at_blobs(varimarch.render(values, **look))
    assert pixels[0][1] > 60 and pixels[0][1] > 2 * pixels[0][0], "the first is green"
    assert min(pixels[1][0], pixels[1][2]) > 60 and pixels[1][0] > 2 * pixels[1][1], "magenta"
    assert pixels[2].max() > 60, "ranges of channels may differ by any factor"
    changed = [{"visible": False}, {"rgb": "white", "opacity": 0.5}, {"window": (1e6, 2e6)}]
    hidden, white, empty = colours_at_blobs(varimarch.render(values, channels=changed, **look))
    assert hidden.max() == 0 and empty.max() == 0
    assert 20 < white[0] == white[1] == white[2], white


def a_function_for_all_channels_is_in_units_of_the_data(_folder):
    values = blobs(1000, numpy.uint16)
    look = {"view": "anterior", "shade": False, "opacity": [(0, 0), (1000, 1)], **SMALL}
    for pixel in colours_at_blobs(varimarch.render(values, color="white", **look)):
        assert 60 < pixel[0] == pixel[1] == pixel[2], pixel


def values_in_cells_are_drawn(_folder):
    values = ball(24)
    cells = vtkImageData()
    cells.SetDimensions(25, 25, 25)
    cells.SetOrigin(9.5, 9.5, 9.5)
    cells.GetCellData().SetScalars(numpy_to_vtk(values.reshape(-1)))
    points = varimarch.to_image(values, (1, 1, 1), (10, 10, 10))
    assert (varimarch.render(cells, **SMALL) == varimarch.render(points, **SMALL)).all()


def warning_of(volume, **arguments):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        varimarch.render(volume, **{**SMALL, **arguments})
    return [str(warning.message) for warning in caught]


def pictures_of_nothing_say_why(_folder):
    values = ball(24)
    for reason, arguments in (
        (f"is 0 at all values of the volume, 0 to {values.max()}, and above 0 only above 4000",
         {"opacity": [(4000, 0), (5000, 1)]}),
        ("only", {"opacity": [(0, 0), (2000, 0.001)], "opacity_unit_distance": 1e6}),
        ("outside of the view", {"clipping_range": (1e-3, 2e-3)}),
        ("the colour of the background", {"color": "black", "shade": False}),
    ):
        found = warning_of(values, **arguments)
        assert len(found) == 1 and found[0].startswith("Nothing is visible: "), found
        assert reason in found[0] and found[0].endswith("."), found
    assert warning_of(values * numpy.nan, preset="ct-bone") == [
        "Nothing is visible: no value of the volume is a finite number."
    ]


def pictures_with_anything_in_them_say_nothing(_folder):
    """A single voxel in one corner of the picture."""
    values = numpy.zeros((24, 24, 24), numpy.uint8)
    values[-1, 0, 0] = 200
    assert not warning_of(values, opacity=[(0, 0), (200, 1)], color="white", shade=False)
    assert not warning_of(values, background="white", preset="pet-maximum")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
