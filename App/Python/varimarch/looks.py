"""Looks: presets and transfer functions, in the format of Documentation/SceneFormat.md."""

import json

import numpy
from vtkmodules.vtkCommonColor import vtkNamedColors

from . import _scene
from .arguments import choice, number, three_numbers
from .images import to_array

PRESETS = json.loads(_scene.presets())


def presets():
    """Returns the presets for render(..., preset=NAME): a dictionary from name to description."""
    return {name: PRESETS[name]["description"] for name in sorted(PRESETS)}


def look_of(preset, image):
    """Returns a preset's look, with values in the units of the image's data."""
    look = PRESETS[choice("preset", preset, presets())]
    if look["domain"] == "relative" and not numpy.isfinite(to_array(image)).any():
        raise ValueError("volume: expected finite values, found none")
    return json.loads(_scene.in_units_of_data(image, json.dumps(look)))


def color_nodes(color):
    """Makes nodes from one colour for all values, or from pairs (value, colour) in ascending order."""
    if isinstance(color, str):
        color = [(0.0, color)]
    return [
        {"value": value, "rgb": rgb_of(node_color)}
        for value, node_color in nodes_of("color", "(value, color)", color)
    ]


def opacity_nodes(opacity):
    """Makes nodes from pairs (value, opacity) in ascending order."""
    return [
        {"value": value, "opacity": number("opacity", node_opacity, 0, 1)}
        for value, node_opacity in nodes_of("opacity", "(value, opacity)", opacity)
    ]


def nodes_of(name, form, nodes):
    try:
        pairs = [(float(value), what) for value, what in nodes]
    except (TypeError, ValueError):
        pairs = []
    if not pairs:
        raise ValueError(f"{name}: expected a list of {form}, found {nodes!r}")
    values = [value for value, _ in pairs]
    if not numpy.isfinite(values).all() or values != sorted(values):
        raise ValueError(f"{name}: expected finite values in ascending order, found {values}")
    return pairs


def rgb_of(color):
    """Returns three numbers from 0 to 1, given them or a colour name of HTML or vtkNamedColors."""
    if isinstance(color, str):
        names = vtkNamedColors()
        if not names.ColorExists(color):
            raise ValueError(f'color: unknown name "{color}"')
        return tuple(names.GetColor3d(color))
    rgb = three_numbers("color", color)
    if rgb.min() < 0.0 or rgb.max() > 1.0:
        raise ValueError(f"color: expected red, green and blue from 0 to 1, found {tuple(rgb)}")
    return tuple(rgb)
