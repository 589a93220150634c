"""Every setter that VTK's wrapping knows of an object, with values by type and range."""

import re
import types
from dataclasses import dataclass
from typing import Callable


@dataclass
class Change:
    """A change of one object of a scene, and the way back."""

    target: str  # the object's name in the scene
    setter: str
    text: str
    make: Callable
    undo: Callable
    is_alias: bool = False  # ShadowsOn is one of SetShadows

    def __str__(self):
        return f"{self.target}.{self.text}"


# The methods that change an object: setters, switches, and what is added or moved.
MUTATOR = re.compile(
    r"Set[A-Z].*|.*(On|Off)$|(Add|Remove|Insert|Replace|Allocate|Fill|Build)[A-Z].*|"
    r"(Adjust|Rotate|Zoom|Push|Azimuth|Elevation|Roll|Yaw|Pitch|Dolly|Apply)\w*|"
    r"(Deep|Shallow)Copy"
)


def mutators(thing):
    return [
        name
        for name in dir(thing)
        if MUTATOR.fullmatch(name) and isinstance(getattr(thing, name), types.BuiltinMethodType)
    ]


def signatures(method):
    """The types of the arguments of each form of a method, without self."""
    text = re.sub(r"\s+", " ", method.__doc__ or "")
    forms = re.findall(rf"\b{method.__name__}\(self(?:, )?(.*?)\) -> ", text)
    return [re.findall(r"(\w+):([^:]+?)(?=, \w+:|$)", form) for form in forms]


def is_index(argument):
    name, kind = argument
    return name in ("index", "i", "idx") and kind == "int"


def getter_of(thing, name):
    return getattr(thing, f"Get{name}", None)


def value_of(getter, indexed):
    try:
        return getter(0) if indexed else getter()
    except TypeError:
        return None


def limits_of(thing, name):
    ends = [getter_of(thing, f"{name}{end}Value") for end in ("Min", "Max")]
    return tuple(end() for end in ends) if all(ends) else None


def others(value, limits, is_switch):
    """Values beside the present one."""
    if is_switch or isinstance(value, bool):
        return [not value]
    if isinstance(value, (tuple, list)):
        if not all(isinstance(number, (int, float)) for number in value):
            return []
        ints = all(isinstance(number, int) for number in value)
        return [tuple(n + i + 1 if ints else 1.2 * n + 0.1 + 0.05 * i for i, n in enumerate(value))]
    if isinstance(value, int):
        if limits and limits[1] - limits[0] <= 12:
            return [one for one in range(limits[0], limits[1] + 1) if one != value]
        return [value + 1]
    if isinstance(value, float):
        lower, upper = limits or (-1e30, 1e30)
        tried = [1.3 * value + 0.07, 0.6 * value - 0.03]
        inside = {min(max(one, lower), upper) for one in tried}
        return sorted(one for one in inside if one != value)
    return []


def literal(value):
    if isinstance(value, tuple):
        return "(" + ", ".join(literal(one) for one in value) + ")"
    return f"{value:g}" if isinstance(value, float) else str(value)


def call(target, name, *arguments):
    return lambda scene: getattr(scene[target], name)(*arguments)


def switches(target, thing, name):
    """ShadowsOn and ShadowsOff, or SetMaskTypeToBinary, set back by their setter."""
    base = re.sub(r"(On|Off)$", "", name)
    if name.startswith("Set"):
        base = re.split(r"To(?=[A-Z])", name[3:])[0]
    getter, setter = getter_of(thing, base), f"Set{base}"
    if not getter or not hasattr(thing, setter):
        return []
    old = value_of(getter, False)
    if old is None:
        return []
    undo = call(target, setter, old)
    return [Change(target, name, f"{name}()", call(target, name), undo, is_alias=True)]


def automatic(target, thing, name):
    """The changes by a method, as far as its signature and a getter tell them."""
    forms = signatures(getattr(thing, name))
    if [] in forms:
        return switches(target, thing, name)
    getter = getter_of(thing, name[3:])
    if not name.startswith("Set") or not getter:
        return []
    indexed = any(is_index(form[0]) for form in forms)
    old = value_of(getter, indexed)
    if old is None:
        return []
    is_switch = isinstance(old, int) and hasattr(thing, name[3:] + "On")
    changes = []
    for value in others(old, limits_of(thing, name[3:]), is_switch):
        before = (0,) if indexed else ()
        spread = isinstance(value, tuple) and any(
            len(form) == len(value) + len(before) for form in forms
        )
        new, back = (value, old) if spread else ((value,), (old,))
        changes.append(
            Change(
                target,
                name,
                f"{name}{literal((*before, *new))}",
                call(target, name, *before, *new),
                call(target, name, *before, *back),
            )
        )
    return changes
