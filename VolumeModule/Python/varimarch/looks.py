"""Looks: presets and transfer functions, and the vtkVolumeProperty that they become."""

import json
import pathlib

import numpy
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

from .arguments import choice, number, three_numbers
from .images import to_array

PRESET_FOLDER = pathlib.Path(__file__).parent / "presets"


def presets():
    """What there is for render(..., preset=NAME): a dictionary from name to description."""
    texts = [json.loads(path.read_text()) for path in sorted(PRESET_FOLDER.glob("*.json"))]
    return {look["name"]: look["description"] for look in texts}


def look_of(preset):
    """What Data/Presets says of a name: Documentation/SceneFormat.md tells the keys."""
    return json.loads((PRESET_FOLDER / f"{choice('preset', preset, presets())}.json").read_text())


def property_of(image, look, color, opacity, opacity_unit_distance, shade):
    """A vtkVolumeProperty: the preset's look, with what is given in its place, as in render()."""
    units = units_of_data(image) if look["domain"] == "relative" else float
    volume_property = vtkVolumeProperty()
    volume_property.SetColor(
        color_function(color)
        if color is not None
        else color_function([(units(node["value"]), node["rgb"]) for node in look["colors"]])
    )
    volume_property.SetScalarOpacity(
        opacity_function(opacity)
        if opacity is not None
        else opacity_function([(units(node["value"]), node["opacity"]) for node in look["opacities"]])
    )
    volume_property.SetScalarOpacityUnitDistance(
        number("opacity_unit_distance", opacity_unit_distance, 1e-30, 1e30)
    )
    volume_property.SetInterpolationTypeToLinear()
    apply_shading(volume_property, look["shading"], shade)
    return volume_property


def units_of_data(image):
    """A function from relative values to the data's: 0 is its 1st percentile, 1 its 99.9th."""
    values = to_array(image)
    finite = values[numpy.isfinite(values)] if values.dtype.kind == "f" else values
    if not finite.size:
        raise ValueError("volume: none of its values is finite")
    zero, one = numpy.percentile(finite, (1.0, 99.9), method="inverted_cdf").astype(float)
    return lambda value: zero + value * (one - zero)


def color_function(color):
    """From a colour for all values, or nodes (value, colour) in the order of their values."""
    function = vtkColorTransferFunction()
    function.AllowDuplicateScalarsOn()
    if isinstance(color, str):
        color = [(0.0, color)]
    for value, node_color in nodes_of("color", "(value, color)", color):
        function.AddRGBPoint(value, *rgb_of(node_color))
    return function


def opacity_function(opacity):
    """From nodes (value, opacity) in the order of their values."""
    function = vtkPiecewiseFunction()
    function.AllowDuplicateScalarsOn()
    for value, node_opacity in nodes_of("opacity", "(value, opacity)", opacity):
        function.AddPoint(value, number("opacity", node_opacity, 0, 1))
    return function


def nodes_of(name, form, nodes):
    try:
        pairs = [(float(value), what) for value, what in nodes]
    except (TypeError, ValueError):
        pairs = []
    if not pairs:
        raise ValueError(f"{name}: expected a list of {form}, found {nodes!r}")
    values = [value for value, _ in pairs]
    if not numpy.isfinite(values).all() or values != sorted(values):
        raise ValueError(f"{name}: expected finite values in rising order, found {values}")
    return pairs


def rgb_of(color):
    """Three numbers from 0 to 1, from them or from a name of HTML's or vtkNamedColors'."""
    if isinstance(color, str):
        names = vtkNamedColors()
        if not names.ColorExists(color):
            raise ValueError(f'color: unknown name "{color}"')
        return tuple(names.GetColor3d(color))
    rgb = three_numbers("color", color)
    if rgb.min() < 0.0 or rgb.max() > 1.0:
        raise ValueError(f"color: expected red, green and blue from 0 to 1, found {tuple(rgb)}")
    return tuple(rgb)


def apply_shading(volume_property, shading, shade):
    volume_property.SetShade(shading["enabled"] if shade is None else bool(shade))
    volume_property.SetAmbient(shading.get("ambient", 0.2))
    volume_property.SetDiffuse(shading.get("diffuse", 0.8))
    volume_property.SetSpecular(shading.get("specular", 0.2))
    volume_property.SetSpecularPower(shading.get("specularPower", 16.0))
