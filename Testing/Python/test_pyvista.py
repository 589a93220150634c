#!/usr/bin/env python3
"""Draws with PyVista, by VTK's mapper and by ours, and compares. Run by hand: Debian 12 has no PyVista.

Usage: test_pyvista.py [FOLDER]   FOLDER: gets the images
PYTHONPATH has to contain PyVista and varimarch. Needs an X display, such as that of xvfb-run.
"""

import contextlib
import os
import pathlib
import sys
import tempfile

import numpy
import pyvista
import varimarch

os.environ["VARIMARCH_VERBOSE"] = "1"
WE_DRAW = "Varimarch: The variation field mapper draws."
# At a twentieth of a voxel the mappers differ by rounding and by VTK's tables [1/255]. The other pixels,
# 1 in 100, are holes that VTK's mapper leaves at clipping planes, and neighbours in PyVista's table of
# 256 colours.
TOLERATED = 4
AMONG = 0.99
LOOK = {"cmap": "viridis", "opacity": "sigmoid", "show_scalar_bar": False}


def ball(side=40):
    grid = pyvista.ImageData(dimensions=(side, side, side), spacing=(1.0, 1.0, 1.5))
    x, y, z = (axis / (side - 1) - 0.5 for axis in numpy.mgrid[:side, :side, :side])
    grid["values"] = (1.0 - 2.0 * numpy.sqrt(x * x + 2 * y * y + z * z)).ravel(order="F")
    return grid


def plain(plotter, mapper):
    return plotter.add_volume(ball(), mapper=mapper, **LOOK)


def opacity_per_mm(plotter, mapper):
    return plotter.add_volume(ball(), mapper=mapper, opacity_unit_distance=4.0, **LOOK)


def shaded_maximum(plotter, mapper):
    return plotter.add_volume(ball(), mapper=mapper, blending="maximum", shade=True, **LOOK)


def clipped_by_a_widget(plotter, mapper):
    volume = plotter.add_volume(ball(), mapper=mapper, **LOOK)
    plotter.add_volume_clip_plane(volume, normal=(-1, 0.3, 0), interaction_event="always")
    # The mappers treat the antialiased lines of the widget differently.
    plotter.plane_widgets[-1].Off()
    return volume


def rectilinear_grid(plotter, mapper):
    """The plain image on a grid of another kind; VTK's mapper draws these half a voxel off."""
    x = numpy.arange(40.0)
    grid = pyvista.RectilinearGrid(x, x, 1.5 * x)
    grid["values"] = ball()["values"]
    return plotter.add_volume(grid, mapper=mapper, **LOOK)


def time_series(plotter, mapper):
    grid = ball()
    volume = plotter.add_volume(grid, mapper=mapper, clim=[0, 1], **LOOK)
    plotter.render()
    for step in range(3):
        grid["values"][:] = numpy.roll(ball()["values"], 5 * step)
        grid.Modified()
        plotter.render()
    return volume


# Cases, and the one that VTK's mapper draws for comparison.
CASES = {
    case: case for case in (plain, opacity_per_mm, shaded_maximum, clipped_by_a_widget, time_series)
}
CASES[rectilinear_grid] = plain


@contextlib.contextmanager
def standard_error_in(file):
    """Sends what C++ and Python say on standard error to a file."""
    kept = os.dup(2)
    os.dup2(file.fileno(), 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


def draw(case, enabled, mapper="gpu"):
    varimarch.enable(enabled)
    with tempfile.TemporaryFile("w+") as said, standard_error_in(said):
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 200))
        volume = case(plotter, mapper)
        volume.mapper.SetAutoAdjustSampleDistances(False)
        volume.mapper.SetSampleDistance(0.05)
        picture = plotter.screenshot(None, return_img=True)
        plotter.close()
        said.seek(0)
        messages = said.read()
    assert messages.strip() == (WE_DRAW if enabled else ""), messages
    return picture


def compare(case, reference, folder):
    vtks, ours, smart = draw(reference, False), draw(case, True), draw(case, True, "smart")
    if folder:
        varimarch.write_png(numpy.hstack([vtks, ours, smart]), folder / f"{case.__name__}.png")
    assert len(numpy.unique(ours)) > 50, "nothing is drawn"
    for name, picture in (("gpu", ours), ("smart", smart)):
        difference = numpy.abs(picture.astype(int) - vtks).max(axis=2)
        usual = numpy.quantile(difference, AMONG)
        print(f"{case.__name__}, {name}: {usual:.0f}, largest {difference.max()} of 255")
        assert usual <= TOLERATED


if __name__ == "__main__":
    print("PyVista", pyvista.__version__, "with VTK", pyvista.vtk_version_info)
    for tested, truth in CASES.items():
        compare(tested, truth, pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None)
