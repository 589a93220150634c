"""Conversion of VTK's errors to exceptions, and of its warnings to Python's."""

import contextlib
import re
import warnings


@contextlib.contextmanager
def vtk_messages_as_exceptions(*objects):
    """Raises the first error that the objects report as a RuntimeError; warnings become Python's."""
    errors = []

    def on_error(_sender, _event, text):
        errors.append(sentence_of(text))

    def on_warning(_sender, _event, text):
        # Level 1 is this function, level 2 read() or write_png(), level 3 its caller.
        warnings.warn(sentence_of(text), RuntimeWarning, stacklevel=3)

    on_error.CallDataType = on_warning.CallDataType = "string0"
    observers = [
        (watched, watched.AddObserver(event, action))
        for watched in objects
        for event, action in (("ErrorEvent", on_error), ("WarningEvent", on_warning))
    ]
    try:
        yield
    finally:
        for watched, observer in observers:
            watched.RemoveObserver(observer)
    if errors:
        raise RuntimeError(errors[0])


def sentence_of(vtk_text):
    """Returns the Text in VTK's message 'ERROR: In f.cxx, line 1\\nvtkA (0x1): Text'."""
    return re.sub(r"^\w+: In .*, line \d+\n\w+ \(\w+\): ", "", vtk_text).strip()
