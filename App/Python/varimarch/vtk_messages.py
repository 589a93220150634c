"""VTK's errors as exceptions, and its warnings as Python's."""

import contextlib
import re
import warnings


@contextlib.contextmanager
def vtk_messages_as_exceptions(*objects):
    """Collects what the objects report meanwhile; raises the first error as a RuntimeError."""
    errors = []

    def on_error(_sender, _event, text):
        errors.append(sentence_of(text))

    def on_warning(_sender, _event, text):
        # This function, then read() or write_png(), then its caller.
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
    """VTK's text without its first line and address: 'ERROR: In f.cxx, line 1\\nvtkA (0x1): Text'."""
    return re.sub(r"^\w+: In .*, line \d+\n\w+ \(\w+\): ", "", vtk_text).strip()
