"""Labels over a volume, in the format of Documentation/SceneFormat.md."""

import json
import os

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from .arguments import named_type, number
from .images import to_array, to_image
from .looks import rgb_of


def labels_of(labels, image):
    """Returns what the extension module takes: a path, or a vtkImageData with labels.

    An array gets the geometry of the image, whose shape it must have.
    """
    if isinstance(labels, (str, os.PathLike)):
        return os.fspath(labels)
    if isinstance(labels, vtkImageData):
        return labels
    values = numpy.asarray(labels)
    if values.dtype.kind not in "biu":
        raise TypeError(
            "labels: expected a path, a vtkImageData or an array of integers, found "
            + (f"values of type {values.dtype}" if values.ndim else named_type(labels))
        )
    shape = image.GetDimensions()[::-1]
    if values.shape != shape:
        raise ValueError(
            f"labels: expected the shape {shape} of the volume, found {values.shape}; for labels on "
            "another grid, pass a vtkImageData or a path"
        )
    on_grid = to_image(values)
    on_grid.SetOrigin(image.GetOrigin())
    on_grid.SetSpacing(image.GetSpacing())
    on_grid.SetDirectionMatrix(image.GetDirectionMatrix())
    return on_grid


def segments_text(colors, opacity):
    """Returns the segments for these colours by label as JSON."""
    if not isinstance(colors, dict):
        raise TypeError(
            f"label_colors: expected a dictionary {{label: colour}}, found {named_type(colors)}"
        )
    segments = []
    for label, color in colors.items():
        if isinstance(label, bool) or not isinstance(label, (int, numpy.integer)) or label == 0:
            raise ValueError(f"label_colors: expected whole numbers but 0 as labels, found {label!r}")
        segments.append({"value": int(label), "color": rgb_of(color), "opacity": opacity})
    return json.dumps(segments)


def drawn_labels(image, labels, colors, opacity, blend):
    """Returns the arguments of the extension module for labels; none without labels."""
    if labels is None:
        if colors is not None:
            raise ValueError("label_colors: expected only with labels")
        return ()
    if blend != "composite" or to_array(image).ndim != 3:
        raise ValueError(
            'labels: expected blend="composite" and a volume of one component, found '
            f'blend="{blend}" and {image.GetNumberOfScalarComponents()}'
        )
    opacity = number("label_opacity", opacity, 0, 1)
    segments = segments_text({} if colors is None else colors, opacity)
    return labels_of(labels, image), segments, opacity
