#!/usr/bin/env python3
"""Uses the package varimarch as a user does, without a display.

Usage: test_python.py CASE [VARIMARCH]
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import warnings

import numpy
import varimarch
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume, vtkVolumeProperty

from nifti_files import nifti_of_times

SMALL = {"size": (32, 32)}
WHITE = {
    "color": "white",
    "opacity": [(0, 0), (100, 1)],
    "shade": False,
    "background": "black",
    **SMALL,
}


def ball(side=24):
    """Values that fall from 500 at the centre to below 0 in the corners."""
    z, y, x = numpy.mgrid[-1 : 1 : side * 1j, -1 : 1 : side * 1j, -1 : 1 : side * 1j]
    return 500 - 400 * numpy.sqrt(x * x + 2 * y * y + z * z)


def pixels_of_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]


def draws_what_the_program_draws(folder):
    """Presets, cameras and sizes have the same meaning here and on the command line."""
    volume = folder / "ball.vti"
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(volume))
    writer.SetInputData(varimarch.to_image(ball().astype(numpy.int16), (1, 2, 3), (4, 5, 6)))
    writer.Write()
    looks = [{"preset": preset} for preset in varimarch.presets()]
    views = [{"view": view} for view in varimarch.pictures.VIEWS]
    turned = {"view": "left", "azimuth": 20, "elevation": -30, "zoom": 1.2}
    for arguments in looks + views + [turned]:
        arguments = {"preset": "ct-bone", **arguments}
        options = [f"--{name}={value}" for name, value in arguments.items()]
        subprocess.run([sys.argv[2], "render", volume, "-o", folder / "program.png", "--size=40x30",
                        *options], check=True, stdout=subprocess.DEVNULL)
        picture = varimarch.render(varimarch.read(volume), size=(40, 30), **arguments)
        assert numpy.array_equal(picture, pixels_of_png(folder / "program.png")), arguments
        varimarch.write_png(picture, folder / "python.png")
        assert numpy.array_equal(picture, pixels_of_png(folder / "python.png"))


def axes_lie_where_the_patient_is(_folder):
    """Seen from the front, z points up and x, the patient's left, to the right."""
    array = numpy.zeros((16, 16, 16))
    array[10:14, 6:10, 2:6] = 100
    rows, columns = numpy.nonzero(varimarch.render(array, **WHITE)[:, :, 0])
    assert rows.size and rows.max() < 16 and columns.max() < 16, (rows, columns)
    stretched = varimarch.render(array, spacing=(1, 1, 4), **WHITE)
    rows, columns = numpy.nonzero(stretched[:, :, 0])
    assert numpy.ptp(rows) > 2 * numpy.ptp(columns), "spacing is not of x, y, z"


def types_of_numbers_make_no_difference(_folder):
    values = numpy.clip(ball(), 0, 100).round()
    expected = varimarch.render(values, **WHITE)
    assert expected.any()
    for kind in ("u1", "i1", "<u2", ">i2", "<i4", ">u4", "i8", "u8", "<f2", ">f4", "g"):
        picture = varimarch.render(values.astype(kind), **WHITE)
        difference = abs(picture.astype(int) - expected)
        assert difference.max() <= 1, f"{kind}: off by {difference.max()}"
    for layout in (numpy.asfortranarray(values), numpy.repeat(values, 2, axis=2)[:, :, ::2]):
        assert numpy.array_equal(varimarch.render(layout, **WHITE), expected)
    varimarch.render(values > 50, preset="mr-head", **SMALL)


def arrays_and_images_share_memory(_folder):
    array = ball(5)[:, :, :4].copy()
    direction = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]
    image = varimarch.to_image(array, (1, 2, 3), (4, 5, 6), direction)
    assert image.GetDimensions() == (4, 5, 5) and image.GetSpacing() == (1, 2, 3)
    assert image.GetDirectionMatrix().GetElement(0, 1) == 1
    point = [0.0, 0.0, 0.0]
    image.TransformIndexToPhysicalPoint((0, 1, 0), point)
    assert point == [6, 5, 6], point
    assert numpy.shares_memory(varimarch.to_array(image), array)
    expected = array.copy()
    del array
    assert numpy.array_equal(varimarch.to_array(image), expected), "the memory was given back"


def every_blend_draws_its_own(_folder):
    look = {"color": [(-300, "black"), (500, (1, 0.9, 0.5))], "opacity": [(-300, 0.01), (500, 0.1)]}
    pictures = {
        varimarch.render(ball(), blend=blend, **look, **SMALL).tobytes()
        for blend in ("composite", "maximum", "minimum", "average", "additive")
    }
    assert len(pictures) == 5, "two blends draw the same picture"


def lights_and_quality_change_the_picture(_folder):
    look = {"color": "white", "opacity": [(200, 0), (250, 1)], "shade": True, **SMALL}
    upper_right = {"kind": "camera", "direction": (1, 1, 1), "color": "ivory", "intensity": 0.9}
    choices = (
        {},
        {"lights": [upper_right]},
        {"lights": [upper_right], "shadows": True},
        {"lights": [upper_right], "shadows": 0.5},
        {"lights": [{**upper_right, "softness": 20}], "shadows": True},
        {"scattering": 0.5},
        {"scattering": 0.5, "anisotropy": 0.4},
        {"scattering": 0.5, "lights": [upper_right], "scattering_reach": 0.5},
        {"occlusion": 0.5},
        {"occlusion": 0.5, "occlusion_reach": 3},
        {"lights": [{"kind": "head"}, upper_right]},
        {"damping": 300},
        {"regions": [{"shape": "ellipse", "values": (100, 400), "gradients": (1, 60),
                      "rgb": "ivory", "opacity": 0.3}]},
        {"clipping_range": (1, 2)},
        {"interpolation": "nearest"},
        {"interpolation": "cubic"},
        {"error_tolerance": 0, "early_termination": 0.5},
        {"error_tolerance": 0, "early_termination": 0.5, "jitter": True},
    )
    pictures = {varimarch.render(ball(), **look, **choice).tobytes() for choice in choices}
    assert len(pictures) == len(choices), "two arguments draw the same picture"
    lit = varimarch.render(ball(), **look, lights=[upper_right]).astype(int)
    assert lit[:16, 16:].sum() > 1.2 * lit[16:, :16].sum(), "light from the upper right"
    head = varimarch.render(ball(), **look, lights=[{"kind": "head"}])
    assert numpy.array_equal(head, varimarch.render(ball(), **look))


def what_is_wrong_is_one_sentence(folder):
    empty = vtkImageData()
    empty.SetDimensions(4, 4, 4)
    bits = vtkImageData()
    bits.SetDimensions(4, 4, 4)
    bits.AllocateScalars(VTK_BIT, 1)
    good = ball(8)
    cases = (
        (ValueError, "shape (3, 3)", lambda: varimarch.render(numpy.zeros((3, 3)))),
        (TypeError, "read it by", lambda: varimarch.render("head.nii")),
        (TypeError, "read it by", lambda: varimarch.render(folder / "head.nii")),
        (TypeError, "found None", lambda: varimarch.render(None)),
        (TypeError, "found a vtkRectilinearGrid", lambda: varimarch.render(vtkRectilinearGrid())),
        (TypeError, "found None", lambda: varimarch.to_array(None)),
        (TypeError, "found an int", lambda: varimarch.capture(3)),
        (ValueError, "Render() first", lambda: varimarch.capture(varimarch.vtkHeadlessRenderWindow())),
        (ValueError, "parallel: expected True", lambda: varimarch.render(good, parallel="no")),
        (ValueError, "shade: expected True", lambda: varimarch.render(good, shade="no")),
        (ValueError, "by 255", lambda: varimarch.render(good, color=(255, 128, 0))),
        (ValueError, "list of dictionaries", lambda: varimarch.render(good, lights={"kind": "head"})),
        (ValueError, '"position"', lambda: varimarch.render(good, lights=[{"kind": "positional"}])),
        (ValueError, "direction", lambda: varimarch.render(good, lights=[{"direction": 3}])),
        (ValueError, "list of dictionaries", lambda: varimarch.render(good, regions="ellipse")),
        (ValueError, '"values"', lambda: varimarch.render(good, regions=[{"shape": "ellipse"}])),
        (ValueError, "values: expected 2", lambda: varimarch.render(good, regions=[{"values": 3}])),
        (ValueError, 'blend="composite"',
         lambda: varimarch.render(good, blend="maximum", regions=[{"shape": "ellipse"}])),
        (ValueError, "ascending", lambda: varimarch.render(good, clipping_range=(5, 2))),
        (ValueError, 'did you mean "cubic"', lambda: varimarch.render(good, interpolation="cubik")),
        (ValueError, "damping", lambda: varimarch.render(good, damping=-1)),
        (ValueError, "early_termination", lambda: varimarch.render(good, early_termination=1)),
        (ValueError, "opacity is 0", lambda: varimarch.render(good, color="transparent")),
        (ValueError, 'did you mean "brown"?', lambda: varimarch.render(good, color="browm")),
        (ValueError, "#ff8800", lambda: varimarch.render(good, background="#ff88")),
        (TypeError, "complex128", lambda: varimarch.render(good.astype(complex))),
        (ValueError, "finite", lambda: varimarch.render(good * numpy.nan)),
        (ValueError, "no scalars", lambda: varimarch.render(empty)),
        (RuntimeError, "scalars", lambda: varimarch.render(empty, preset="ct-bone")),
        (RuntimeError, "single bits", lambda: varimarch.render(bits, preset="ct-bone")),
        (ValueError, "spacing", lambda: varimarch.render(good, spacing=(1, 0, 1))),
        (ValueError, "its own", lambda: varimarch.render(empty, spacing=(1, 1, 1))),
        (ValueError, 'did you mean "ct-bone"?', lambda: varimarch.render(good, preset="ct-bon")),
        (ValueError, "ascending", lambda: varimarch.render(good, opacity=[(1, 0), (0, 1)])),
        (ValueError, "found 2", lambda: varimarch.render(good, opacity=[(1, 2)])),
        (ValueError, "list of", lambda: varimarch.render(good, opacity=0.5)),
        (ValueError, "10000", lambda: varimarch.render(good, opacity=[(1, 1)] * 10001)),
        (ValueError, "zoom", lambda: varimarch.render(good, zoom=0)),
        (ValueError, "elevation", lambda: varimarch.render(good, elevation=90)),
        (ValueError, "size", lambda: varimarch.render(good, size=(0, 4))),
        (ValueError, "known: ", lambda: varimarch.render(good, view="front")),
        (OSError, "none.nrrd", lambda: varimarch.read(folder / "none.nrrd")),
        (ValueError, "float64", lambda: varimarch.write_png(good, folder / "a.png")),
        (OSError, "none", lambda: varimarch.write_png(varimarch.render(good, **SMALL),
                                                      folder / "none" / "a.png")),
    )
    for kind, part, action in cases:
        try:
            action()
        except kind as error:
            text = str(error)
            assert part in text and "\n" not in text and "(0x" not in text, text
        else:
            raise AssertionError(f"nothing is wrong where {part} was expected")


def without_opengl_is_one_sentence(folder):
    """EGL looks for drivers at its first call, here in an empty folder."""
    os.environ["__EGL_VENDOR_LIBRARY_DIRS"] = str(folder)
    try:
        varimarch.render(ball(8))
    except RuntimeError as error:
        assert "EGL" in str(error) and "\n" not in str(error), error
    else:
        raise AssertionError("there is a picture without OpenGL")


def warnings_are_python_warnings(_folder):
    """Five hundred thin shells cannot be rendered to one millionth with the allowed number of samples."""
    spikes = [(i, i % 2) for i in range(500)]
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        varimarch.render(ball(), color="white", opacity=spikes, shade=False, error_tolerance=1e-6,
                         **SMALL)
    assert caught and all(str(warning.message)[0].isupper() for warning in caught), caught


def doubts_of_the_reader_are_python_warnings(folder):
    """A NIfTI file that does not say where the patient's left is."""
    path = nifti_of_times(folder / "one.nii", [0])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert varimarch.read(path).GetDimensions() == (3, 4, 5)
    assert any("mirrored" in str(warning.message) for warning in caught), caught
    assert all(warning.filename == __file__ for warning in caught), "it names this call"


def masked_values_are_not_drawn(_folder):
    values = ball()
    for kind in ("f8", "f4", "i2", "u4"):
        array = numpy.clip(values, 0, 500).astype(kind)
        mask = array < 200
        floats = numpy.where(mask, numpy.nan, array)
        expected = varimarch.render(floats, **WHITE)
        assert numpy.array_equal(varimarch.render(numpy.ma.array(array, mask=mask), **WHITE), expected)
        assert not numpy.array_equal(varimarch.render(array, **WHITE), expected)
        unmasked = numpy.ma.array(array)
        assert numpy.shares_memory(varimarch.to_array(varimarch.to_image(unmasked)), array)


def colours_are_what_people_write(_folder):
    def drawn(color):
        return varimarch.render(ball(), **{**WHITE, "color": color}).tobytes()

    assert drawn((1, 0, 0)) == drawn("red") == drawn("#ff0000") == drawn("#F00")
    assert drawn([1.0, 0.0, 0.0]) == drawn(numpy.array((1, 0, 0))) == drawn([(0, (1, 0, 0))])
    assert drawn("#ff8800") != drawn("#ff0000")


def thin_stacks_show_their_face(_folder):
    stack = numpy.full((3, 40, 40), 100.0)
    assert varimarch.render(stack, **WHITE).mean() > 100
    assert varimarch.render(stack, view="anterior", **WHITE).mean() < 50


def the_package_lists_its_contents_only(_folder):
    names = set(dir(varimarch))
    assert names == {*varimarch.__all__, "__doc__", "__version__"}, names
    assert {"render", "read", "vtkVariationFieldVolumeMapper"} <= names
    assert all(getattr(varimarch, name) for name in names)
    assert re.fullmatch(r"\d+\.\d+\.\d+", varimarch.__version__), varimarch.__version__


def a_copy_of_a_process_that_has_drawn_says_so(_folder):
    """multiprocessing copies the process by default; the threads of OpenGL are not in the copy."""
    varimarch.render(ball(8), **SMALL)
    if os.fork() == 0:
        signal.alarm(30)
        try:
            varimarch.render(ball(8), **SMALL)
        except RuntimeError as error:
            os._exit(0 if "spawn" in str(error) else 1)
        os._exit(2)
    assert os.wait()[1] == 0


def other_threads_run_while_it_renders(_folder):
    """Python never switches threads by itself here, so the other one runs if render() lets it."""
    image = varimarch.to_image(ball())
    scene = json.dumps({"look": varimarch.looks.look_of("ct-bone", image), "size": [64, 64]})
    start, runs = threading.Semaphore(0), []

    def run():
        while True:
            start.acquire()
            runs.append(True)

    threading.Thread(target=run, daemon=True).start()
    sys.setswitchinterval(1000)
    start.release()
    varimarch.pictures._scene.render(image, scene, [])
    assert runs, "the other thread waited"


def labels_are_drawn_over_their_volume(folder):
    """Segments have their colour, whatever the values; a file says the same as an array."""
    array = numpy.zeros((16, 16, 16), numpy.int16)
    array[0] = 100
    labels = numpy.zeros(array.shape, numpy.uint8)
    labels[4:12, 4:12, 4:12] = 7
    look = {**WHITE, "opacity": [(0, 0)], "parallel": True}
    assert not varimarch.render(array, **look).any()
    picture = varimarch.render(array, labels=labels, label_colors={7: "#ff8000"}, **look)
    assert picture[16, 16].tolist() == [255, 128, 0] and not picture[2, 2].any()
    half = varimarch.render(
        array, labels=labels, label_colors={7: "white"}, label_opacity=0.5, **look
    )
    assert abs(int(half[16, 16, 0]) - 128) <= 2, half[16, 16]
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(folder / "labels.vti"))
    writer.SetInputData(varimarch.to_image(labels))
    writer.Write()
    path = folder / "labels.vti"
    from_file = varimarch.render(array, labels=path, label_colors={7: "#ff8000"}, **look)
    assert numpy.array_equal(from_file, picture)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        varimarch.render(array, labels=labels, label_colors={8: "red"}, **look)
    assert "segment of the value 8" in str(caught[0].message), caught
    for arguments, words in (
        ({"labels": labels[:8]}, "expected the shape (16, 16, 16)"),
        ({"labels": labels / 2}, "an array of integers, found values of type float64"),
        ({"labels": labels, "blend": "maximum"}, 'expected blend="composite"'),
        ({"labels": labels, "label_colors": {0: "red"}}, "whole numbers but 0"),
        ({"labels": labels, "label_colors": "red"}, "{label: colour}, found a str"),
        ({"labels": labels, "label_opacity": 2}, "label_opacity: expected a number from 0 to 1"),
        ({"label_colors": {1: "red"}}, "expected only with labels"),
    ):
        try:
            varimarch.render(array, **{**look, **arguments})
            raise AssertionError(f"{arguments} was accepted")
        except (TypeError, ValueError) as error:
            assert words in str(error), error


def classes_work_in_a_pipeline(_folder):
    """Uses our mapper and window in an ordinary VTK pipeline in Python."""
    source = vtkRTAnalyticSource()
    mapper = varimarch.vtkVariationFieldVolumeMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(vtkVolumeProperty())
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = varimarch.vtkHeadlessRenderWindow()
    window.SetSize(24, 16)
    window.AddRenderer(renderer)
    window.Render()
    picture = varimarch.capture(window)
    assert picture.shape == (16, 24, 3) and picture.any()
    assert mapper.GetFieldBuilds() == 1 and mapper.GetEstimatedError() <= 1 / 64
    assert varimarch.vtkVolumeFileReader.GetFormatName(-1) is None
    assert varimarch.vtkVolumeFileReader.GetFormatName(0)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
