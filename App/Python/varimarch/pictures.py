"""Rendering of volumes, and images as arrays."""

import inspect
import json
import os

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from . import _scene
from .arguments import ascending_pair, choice, instance, number, truth
from .images import image_of, to_array, to_image
from .labels import drawn_labels
from .looks import (
    channels_of,
    color_nodes,
    lights_of,
    look_of,
    regions_of,
    rgb_of,
    take_opacities,
)
from .overlays import overlays_of
from .settings import SETTINGS, explained, take_settings
from .vtk_messages import vtk_messages_as_exceptions

VIEWS = tuple(SETTINGS["view"]["schema"]["enum"])
BLENDS = ("composite", "maximum", "minimum", "average", "additive")
LEVELS = ("voxels", "coarse", "refined")
# The largest side of a 2D texture that all relevant versions of OpenGL guarantee.
LARGEST_SIDE = 16384


def render(
    volume,
    *,
    spacing=None,
    preset="mr-head",
    color=None,
    opacity=None,
    opacity_unit_distance=None,
    channels=None,
    regions=None,
    shade=None,
    lights=None,
    shadows=False,
    blend=None,
    labels=None,
    label_colors=None,
    label_opacity=1.0,
    overlays=(),
    size=(512, 512),
    background=None,
    parallel=False,
    clipping_range=None,
    detail="voxels",
    **settings,
):
    """Renders a volume, and returns an image as an array [row, column, (red, green, blue)] of uint8.

    volume: an array [z, y, x] of integers or real numbers, or [z, y, x, component] of 2 to 4
        components; or a vtkImageData such as read() returns, with values at points or in cells.
    spacing: distances between the voxels of an array along x, y, z [mm]; default: 1, 1, 1.

    preset: name of the look, one of presets(). The default is for any data, "ct-bone" for Hounsfield
        units.
    color: replaces the preset's colours: one colour, or a list of (value, colour), which is
        interpolated linearly. A colour is a name as "ivory", "#ff8800", or (red, green, blue) from 0
        to 1.
    opacity: replaces the preset's opacities: a list of (value, opacity), with opacities from 0 to 1.
    opacity_unit_distance: the length over which material has these opacities [mm]. Default: 1 for the
        argument opacity and for presets of patients, whom read() knows from DICOM, NIfTI and others,
        and Hounsfield units tell; presets draw another volume, such as an array, as if a cube as
        large had a side of 200 mm.
    channels: the components of a volume with two to four independent ones, a list of dictionaries as
        in Documentation/SceneFormat.md, with any of "rgb", a colour in place of the one of the file;
        "visible", True or False; "opacity", a factor from 0 to 1; and "window", the values that
        look as the first and the last value of the opacities. Components that are colours are drawn
        as they are, and their opacity is that of their alpha or luminance.
    regions: a transfer function of value and gradient magnitude, which replaces colours and opacities:
        a list of dictionaries as in Documentation/SceneFormat.md, such as {"shape": "ellipse",
        "values": (100, 300), "gradients": (50, 200), "rgb": "ivory", "opacity": 0.3}. Composites of
        one component only.
    shade: True to light the volume, so that surfaces are brighter where they face a light. Default:
        the preset's.
    lights: the lights of a shaded volume, a list of dictionaries as in Documentation/SceneFormat.md,
        such as {"kind": "camera", "direction": (1, 1, 1), "color": "ivory"}, a light from the upper
        right; default: a white light at the eye.
    shadows: True, or a strength from 0 (none) to 1, to let volumes cast shadows on themselves and
        on each other, from lights that are not at the eye; shaded volumes show them. Takes about
        three times as long.
    blend: "composite", "maximum", "minimum", "average" or "additive"; default: the preset's.

    labels: segments to draw over the volume: the path of a segmentation (DICOM SEG, .seg.nrrd) or
        label map, an array of integers of the volume's shape, or a vtkImageData on any grid; 0 means
        no segment. A segment has one colour, whatever the volume's values; the rest is drawn as
        usual. Composites only.
    label_colors: colours by label, such as {1: "red", 2: "#00ff00"}; default: those of the file, or
        different ones.
    label_opacity: opacity of the mean thickness of each segment, 0 to 1.

    overlays: further volumes in the same space, drawn in one march with the first, at most three:
        each a volume or a dictionary {"volume": ...} with any of "spacing", "preset", "color",
        "opacity" and "opacity_unit_distance", as of the first volume; "strength", a factor of its
        opacities, 0 to 1; "turn", angles about x, y and z through its middle [degrees]; and "move",
        along x, y and z [mm]. All are composites, without labels.

    size: width and height of the image [pixels].
    background: colour of the background; default: the preset's.
    parallel: True for a parallel projection instead of a perspective one of 30 degrees.
    clipping_range: nearest and farthest distance from the camera that is drawn [mm]; default: all.

    detail: of a volume that read() has left in its file: "voxels", or "coarse" for the means of
        4 x 4 x 4 voxels, which are in memory, as a first image, or "refined" for voxels only where the
        means may change the image by more than half of error_tolerance. Other volumes have only
        voxels.

    Settings of a scene, which replace those of the preset:
SETTINGS

    Raises ValueError or TypeError for bad arguments, and RuntimeError if the volume cannot be
    rendered, each with one sentence.
    """
    image = image_of(volume, spacing)
    look = look_of(preset, image)
    if color is not None:
        look["colors"] = color_nodes(color)
    take_opacities(look, opacity, opacity_unit_distance)
    if "channels" in look:
        look["channels"] = channels_of(channels, look["channels"], color, opacity)
    elif channels is not None:
        raise ValueError(
            "channels: expected a volume of two to four components that are independent, "
            "found one of a single component, or colours"
        )
    if shade is not None:
        look["shading"]["enabled"] = truth("shade", shade)
    if regions is not None:
        look["regions"] = regions_of(regions)
    look["blend"] = choice("blend", blend or look["blend"], BLENDS)
    if regions is not None and (look["blend"] != "composite" or to_array(image).ndim != 3):
        raise ValueError(
            'regions: expected blend="composite" and a volume of one component, found '
            f'blend="{look["blend"]}" and {image.GetNumberOfScalarComponents()}'
        )
    if background is not None:
        look["background"] = rgb_of(background)
    camera = {"projection": "parallel" if truth("parallel", parallel) else "perspective"}
    if clipping_range is not None:
        camera["clippingRange"] = ascending_pair("clipping_range", clipping_range)
    scene = {
        "look": look,
        "camera": camera,
        "render": {"detail": choice("detail", detail, LEVELS)},
        "size": picture_size(size),
        "shadows": number("shadows", shadows, 0, 1),
        "scattering": {"blending": 0.0},
        "occlusion": {"strength": 0.0},
    }
    if lights is not None:
        scene["lights"] = lights_of(lights)
    take_settings(scene, settings)
    scene["overlays"], over = overlays_of(overlays)
    if over and (labels is not None or look["blend"] != "composite"):
        raise ValueError('overlays: expected blend="composite" without labels')
    drawn = drawn_labels(image, labels, label_colors, label_opacity, look["blend"])
    picture = _scene.render(image, json.dumps(scene), over, *drawn)
    # VTK counts rows from the bottom.
    return to_array(picture)[0, ::-1].copy()


def complete(function):
    """Names and explains the settings in the signature and the docstring of a function."""
    signature = inspect.signature(function)
    named = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in SETTINGS
    ]
    function.__signature__ = signature.replace(
        parameters=[*list(signature.parameters.values())[:-1], *named]
    )
    # Python -OO has no docstrings.
    if function.__doc__:
        function.__doc__ = function.__doc__.replace(
            "SETTINGS", "\n".join(explained(name) for name in SETTINGS)
        )


complete(render)


def capture(window):
    """Returns the image in a vtkRenderWindow: an array [row, column, (red, green, blue)] of uint8."""
    advice = "varimarch.render(volume) returns an image without one"
    if instance("window", window, vtkRenderWindow, advice).GetNeverRendered():
        raise ValueError("window: expected one that has been rendered; call its Render() first")
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, False, pixels, 0)
    # VTK counts rows from the bottom.
    return vtk_to_numpy(pixels).reshape(height, width, 3)[::-1].copy()


def write_png(picture, path):
    """Writes an image, an array [row, column, (red, green, blue)] of uint8, to a PNG file."""
    pixels = numpy.asarray(picture)
    if pixels.ndim != 3 or pixels.shape[2] != 3 or pixels.dtype != numpy.uint8:
        raise ValueError(
            "picture: expected an array [row, column, 3] of uint8, "
            f"found one of shape {pixels.shape} of {pixels.dtype}"
        )
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.AllocateScalars(3, 3)
    to_array(image)[0] = pixels[::-1]
    writer = vtkPNGWriter()
    writer.SetFileName(os.fspath(path))
    writer.SetInputData(image)
    try:
        with vtk_messages_as_exceptions(writer):
            writer.Write()
    except RuntimeError as error:
        raise OSError(str(error)) from None


def picture_size(size):
    try:
        width, height = (int(side) for side in size)
    except (TypeError, ValueError):
        width = height = 0
    if not (1 <= width <= LARGEST_SIDE and 1 <= height <= LARGEST_SIDE):
        raise ValueError(
            f"size: expected width and height from 1 to {LARGEST_SIDE} pixels, found {size!r}"
        )
    return width, height
