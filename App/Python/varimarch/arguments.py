"""Checks of arguments. Each function returns the value, or raises a ValueError of one sentence."""

import difflib

import numpy


def choice(name, value, known):
    """Returns a value that must be one of those known."""
    if value in known:
        return value
    near = difflib.get_close_matches(str(value), known, 1)
    advice = f'did you mean "{near[0]}"?' if near else "known: " + ", ".join(known)
    raise ValueError(f'unknown {name} "{value}"; {advice}')


def truth(name, value):
    """Returns a bool, given one or 0 or 1."""
    if isinstance(value, (bool, numpy.bool_)) or (isinstance(value, int) and value in (0, 1)):
        return bool(value)
    raise ValueError(f"{name}: expected True or False, found {value!r}")


def instance(name, value, kind, advice):
    """Returns an object that must be of a class of VTK."""
    if isinstance(value, kind):
        return value
    raise TypeError(f"{name}: expected a {kind.__name__}, found {named_type(value)}; {advice}")


def named_type(value):
    """Returns the name of an object's type with an article, such as "a vtkImageData"."""
    name = type(value).__name__
    return "None" if value is None else f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def number(name, value, low, high):
    """Returns a float from low to high."""
    found = numbers_of(value, ())
    if found is None or not low <= found <= high:
        raise ValueError(f"{name}: expected a number from {low:g} to {high:g}, found {value!r}")
    return float(found)


def whole_number(name, value):
    """Returns an int of at least 0."""
    found = numbers_of(value, ())
    if found is None or found < 0 or found != int(found):
        raise ValueError(f"{name}: expected a whole number of at least 0, found {value!r}")
    return int(found)


def ascending_pair(name, values):
    """Returns two numbers above 0, the smaller one first."""
    found = numbers_of(values, (2,))
    if found is None or not 0.0 < found[0] < found[1]:
        raise ValueError(f"{name}: expected two ascending numbers above 0, found {values!r}")
    return tuple(found.tolist())


def three_numbers(name, values):
    """Returns three finite numbers as an array."""
    found = numbers_of(values, (3,))
    if found is None:
        raise ValueError(f"{name}: expected three finite numbers, found {values!r}")
    return found


def matrix_of_directions(name, values):
    """Returns an invertible matrix as an array of 3 x 3."""
    found = numbers_of(values, (3, 3))
    if found is None or abs(numpy.linalg.det(found)) < 1e-12:
        raise ValueError(f"{name}: expected 3 x 3 numbers that can be inverted, found {values!r}")
    return found


def numbers_of(values, shape):
    """Returns an array of this shape; None if the values have another shape or are not finite."""
    try:
        found = numpy.asarray(values, dtype=float)
    except (TypeError, ValueError):
        return None
    return found if found.shape == shape and numpy.isfinite(found).all() else None
