"""Settings of a scene as arguments: checked and explained as the fields of scenes say."""

import json
import textwrap

from . import _scene
from .arguments import choice, numbers_of, truth

# By argument: the path in the scene, the meaning, unit and default in words, and the schema.
SETTINGS = {
    option.lstrip("-").replace("-", "_"): setting
    for option, setting in json.loads(_scene.settings()).items()
}


def take_settings(scene, given):
    """Puts arguments into a scene; None stands for the default."""
    for name, value in given.items():
        if name not in SETTINGS:
            raise TypeError(f"render() got an unexpected keyword argument '{name}'")
        if value is not None:
            place = scene
            *path, key = SETTINGS[name]["path"]
            for outer in path:
                place = place.setdefault(outer, {})
            place[key] = checked(name, value)


def checked(name, value):
    """Returns the value of a setting, or raises a ValueError of one sentence."""
    schema = SETTINGS[name]["schema"]
    if "enum" in schema:
        return choice(name, value, schema["enum"])
    if schema["type"] == "boolean":
        return truth(name, value)
    found = numbers_of(value, ())
    limits = [
        (words, schema[key], is_good)
        for key, words, is_good in (
            ("minimum", ">=", lambda limit: found >= limit),
            ("exclusiveMinimum", ">", lambda limit: found > limit),
            ("maximum", "<=", lambda limit: found <= limit),
            ("exclusiveMaximum", "<", lambda limit: found < limit),
        )
        if key in schema
    ]
    if found is None or not all(is_good(limit) for _, limit, is_good in limits):
        range_ = " and ".join(f"{words} {limit:g}" for words, limit, _ in limits)
        raise ValueError(f"{name}: expected a number {range_}".rstrip() + f", found {value!r}")
    return float(found)


def explained(name):
    """Returns the paragraph of a setting for a docstring."""
    setting = SETTINGS[name]
    meaning = setting["meaning"]
    usual = setting["usual"]
    if "enum" in setting["schema"]:
        meaning += ": " + ", ".join(f'"{word}"' for word in setting["schema"]["enum"])
        usual = f'"{usual}"'
    elif setting["schema"]["type"] == "boolean":
        meaning = "True to " + meaning
        usual = usual.title()
    unit = f" [{setting['unit']}]" if setting["unit"] else ""
    words = f"{name}: {meaning}{unit}; default: {usual}."
    return textwrap.fill(
        words.replace("`", ""), 100, initial_indent=" " * 4, subsequent_indent=" " * 8
    )
