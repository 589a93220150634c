"""Pictures: one call from a volume to pixels."""

import math
import os

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume

from .arguments import choice, number
from .images import to_array, to_image
from .looks import look_of, property_of, rgb_of
from .VarimarchVolume import vtkHeadlessRenderWindow, vtkVariationFieldVolumeMapper
from .vtk_messages import vtk_messages_as_exceptions

# In LPS space, x to the patient's left, y to the back, z to the head: the direction to the eye, and
# the one that is up in the picture.
VIEWS = {
    "anterior": ((0, -1, 0), (0, 0, 1)),
    "posterior": ((0, 1, 0), (0, 0, 1)),
    "left": ((1, 0, 0), (0, 0, 1)),
    "right": ((-1, 0, 0), (0, 0, 1)),
    "superior": ((0, 0, 1), (0, -1, 0)),
    "inferior": ((0, 0, -1), (0, -1, 0)),
}
# OpenGL's least guaranteed largest side of a 2D texture, in the versions that matter.
LARGEST_SIDE = 16384
BLENDS = {
    "composite": "Composite",
    "maximum": "MaximumIntensity",
    "minimum": "MinimumIntensity",
    "average": "AverageIntensity",
    "additive": "Additive",
}


def render(
    volume,
    *,
    spacing=None,
    preset="mr-head",
    color=None,
    opacity=None,
    opacity_unit_distance=1.0,
    shade=None,
    blend=None,
    size=(512, 512),
    background=None,
    view="anterior",
    azimuth=0.0,
    elevation=0.0,
    zoom=1.0,
    parallel=False,
    error_tolerance=None,
):
    """Draws a volume, and returns the picture: an array [row, column, (red, green, blue)] of uint8.

    volume: an array [z, y, x] of integers or real numbers, or a vtkImageData, as read() returns.
    spacing: of an array, between voxels along x, y, z [mm]; default 1, 1, 1.

    preset: the look, one of presets(). The default shows any data, "ct-bone" Hounsfield units.
    color: instead of the preset's: one colour, or a list of (value, colour); linear between them.
        A colour is a name such as "ivory", or (red, green, blue) from 0 to 1.
    opacity: instead of the preset's: a list of (value, opacity), with opacities from 0 to 1.
    opacity_unit_distance: the length over which material has these opacities [mm].
    shade: whether there is light and shadow; default: as the preset says.
    blend: "composite", "maximum", "minimum", "average" or "additive"; default: as the preset says.

    size: width and height of the picture [pixels].
    background: a colour; default: the preset's.
    view: the side of the patient that the eye is at: "anterior", "posterior", "left", "right",
        "superior" or "inferior". x points to the patient's left, y to the back, z to the head.
    azimuth, elevation: turn and lift the eye from there [degrees].
    zoom: 1 just fits the volume's box into the picture.
    parallel: a parallel projection instead of a perspective one of 30 degrees.

    error_tolerance: largest error accepted in a channel, 0 to 1; smaller takes longer; default: the preset's.

    Raises ValueError or TypeError for bad arguments, RuntimeError when it cannot draw; each with one
    sentence.
    """
    image = image_of(volume, spacing)
    width, height = picture_size(size)
    look = look_of(preset)

    mapper = vtkVariationFieldVolumeMapper()
    mapper.SetInputData(image)
    tolerance = look["errorTolerance"] if error_tolerance is None else error_tolerance
    mapper.SetErrorTolerance(number("error_tolerance", tolerance, 0, 1))
    getattr(mapper, f"SetBlendModeTo{BLENDS[choice('blend', blend or look['blend'], BLENDS)]}")()
    actor = vtkVolume()
    actor.SetMapper(mapper)
    actor.SetProperty(property_of(image, look, color, opacity, opacity_unit_distance, shade))

    renderer = vtkRenderer()
    renderer.SetBackground(rgb_of(look["background"] if background is None else background))
    renderer.AddVolume(actor)
    camera = renderer.GetActiveCamera()
    turn_camera(camera, image.GetCenter(), choice("view", view, VIEWS), azimuth, elevation)
    fit_camera(camera, image.GetBounds(), width / height, parallel)
    camera.Zoom(number("zoom", zoom, 1e-3, 1e3))
    renderer.ResetCameraClippingRange()

    window = vtkHeadlessRenderWindow()
    if not window.InitializeContext():
        raise RuntimeError(window.GetFailureReason())
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    with vtk_messages_as_exceptions(mapper, window, renderer):
        window.Render()
    return capture(window)


def capture(window):
    """The picture that a vtkRenderWindow holds: an array [row, column, (red, green, blue)] of uint8."""
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, False, pixels, 0)
    # VTK counts rows from below.
    return vtk_to_numpy(pixels).reshape(height, width, 3)[::-1].copy()


def write_png(picture, path):
    """Writes a picture, an array [row, column, (red, green, blue)] of uint8, into a PNG file."""
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


def image_of(volume, spacing):
    if not isinstance(volume, vtkImageData):
        return to_image(volume, (1.0, 1.0, 1.0) if spacing is None else spacing)
    if spacing is not None:
        raise ValueError("spacing: is for arrays; the vtkImageData has its own")
    return volume


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


def turn_camera(camera, center, view, azimuth, elevation):
    """Puts the eye at a side of the volume, 1 mm from its middle."""
    towards_eye, up = VIEWS[view]
    camera.SetFocalPoint(center)
    camera.SetPosition(numpy.add(center, towards_eye))
    camera.SetViewUp(up)
    camera.Azimuth(number("azimuth", azimuth, -36000, 36000))
    camera.Elevation(number("elevation", elevation, -89, 89))
    camera.OrthogonalizeViewUp()


def fit_camera(camera, bounds, aspect, parallel):
    """Steps back until every corner of the box is in the picture, whose width is aspect heights."""
    low, high = numpy.reshape(bounds, (3, 2)).T
    corners = numpy.stack(numpy.meshgrid(*zip(low, high)), axis=-1).reshape(8, 3)
    matrix = camera.GetViewTransformMatrix()
    view_from_world = [[matrix.GetElement(row, column) for column in range(3)] for row in range(3)]
    right, above, nearer = view_from_world @ (corners - (low + high) / 2).T
    half_height = numpy.maximum(abs(above), abs(right) / aspect)
    tangent = math.tan(math.radians(camera.GetViewAngle()) / 2)
    distance = max(nearer + half_height / tangent)
    camera.SetPosition(
        numpy.subtract(camera.GetFocalPoint(), distance * numpy.array(camera.GetDirectionOfProjection()))
    )
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(max(half_height))
