"""Looks: presets and transfer functions, in the format of Documentation/SceneFormat.md."""

import difflib
import json
import re

import numpy
from vtkmodules.vtkCommonColor import vtkNamedColors

from . import _scene
from .arguments import choice, number, numbers_of, three_numbers
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
    if isinstance(color, str) or numbers_of(color, (3,)) is not None:
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


def take_opacities(look, opacity, unit_distance):
    """Replaces the opacities of a look, and their length, by those that are given."""
    if opacity is not None:
        look["opacities"] = opacity_nodes(opacity)
        look["opacityUnitDistance"] = 1.0
    if unit_distance is not None:
        look["opacityUnitDistance"] = number("opacity_unit_distance", unit_distance, 1e-30, 1e30)


def lights_of(lights):
    """Returns lights as in the scene format, given such dictionaries with colours of any form."""
    example = '{"kind": "camera", "direction": (1, 1, 1)}'
    return dictionaries_of("lights", lights, example, {"color": 3, "direction": 3, "position": 3})


def channels_of(given, usual, color, opacity):
    """Returns the settings of all channels, given some of them, and those of a preset.

    Curves that replace those of the preset hold for all channels, in units of the data.
    """
    channels = [dict(channel) for channel in usual]
    for channel in channels:
        if color is not None:
            channel.pop("rgb", None)
        if opacity is not None:
            channel.pop("window", None)
    if given is None:
        return channels
    example = '{"rgb": "lime", "window": (100, 2000)}'
    settings = dictionaries_of("channels", given, example, {"rgb": 3, "window": 2})
    if len(settings) > len(channels):
        raise ValueError(
            f"channels: expected at most {len(channels)}, one for each component of the volume, "
            f"found {len(settings)}"
        )
    for channel, changed in zip(channels, settings):
        channel.update(changed)
    return channels


def regions_of(regions):
    """Returns regions as in the scene format, given such dictionaries with colours of any form."""
    example = (
        '{"shape": "ellipse", "values": (100, 300), "gradients": (50, 200), "rgb": "ivory", '
        '"opacity": 0.3}'
    )
    return dictionaries_of("regions", regions, example, {"rgb": 3, "values": 2, "gradients": 2})


def dictionaries_of(name, dictionaries, example, lengths):
    """Returns dictionaries in which colours and arrays are lists of numbers of these lengths."""
    if not isinstance(dictionaries, (list, tuple)) or not all(
        isinstance(one, dict) for one in dictionaries
    ):
        raise ValueError(
            f"{name}: expected a list of dictionaries such as {example}, found {dictionaries!r}"
        )

    def plain(key, value):
        if key in ("color", "rgb"):
            return rgb_of(value)
        if key not in lengths:
            return value
        numbers = numbers_of(value, (lengths[key],))
        if numbers is None:
            raise ValueError(
                f"{name}: {key}: expected {lengths[key]} finite numbers, found {value!r}"
            )
        return numbers.tolist()

    return [{key: plain(key, value) for key, value in one.items()} for one in dictionaries]


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
    """Returns three numbers from 0 to 1, given them, or a colour as "ivory", "#ff8800" or "#f80"."""
    if isinstance(color, str):
        return rgb_of_name(color)
    rgb = three_numbers("color", color)
    if rgb.min() < 0.0 or rgb.max() > 1.0:
        advice = "; divide them by 255" if 0.0 <= rgb.min() and rgb.max() <= 255.0 else ""
        raise ValueError(
            f"color: expected red, green and blue from 0 to 1, found {tuple(rgb.tolist())}{advice}"
        )
    return tuple(rgb)


def rgb_of_name(name):
    """Returns the colour of a name of HTML or vtkNamedColors, or of hexadecimal digits."""
    if name.lower() in ("transparent", "none"):
        raise ValueError(
            f'color: "{name}" is not a colour; values are transparent where their opacity is 0, '
            "and images have no transparency"
        )
    digits = re.fullmatch("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})", name)
    if digits:
        size = len(digits[1]) // 3
        parts = [digits[1][i : i + size] * (3 - size) for i in range(0, 3 * size, size)]
        return tuple(int(part, 16) / 255 for part in parts)
    names = vtkNamedColors()
    if not names.ColorExists(name):
        near = difflib.get_close_matches(name.lower(), names.GetColorNames().split("\n"), 1)
        advice = f'did you mean "{near[0]}"?' if near else 'expected one as "ivory" or "#ff8800"'
        raise ValueError(f'color: unknown name "{name}"; {advice}')
    return tuple(names.GetColor3d(name))
