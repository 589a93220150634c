"""Fields of volumes as arrays."""

from . import _scene
from .arguments import choice, number
from .images import to_array
from .images import image_of

DISTANCES = ("euclidean", "chebyshev")


def variation_field(volume, tolerance, *, distance="euclidean"):
    """Returns how far each voxel's surroundings have about its value: an array [z, y, x] of uint8.

    This is the field S of Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016):
    the largest number of voxels d, from 1 to 255, such that all voxels closer than d have values that
    differ from that of the voxel by less than the tolerance.

    volume: an array [z, y, x] of integers or real numbers, or a vtkImageData such as read() returns.
    tolerance: the difference E, in units of the values.
    distance: "euclidean" for surroundings that are a ball, "chebyshev" for a cube.

    Raises ValueError or TypeError for bad arguments, each with one sentence.
    """
    image = image_of(volume, None)
    field = _scene.variation_field(
        image, number("tolerance", tolerance, 0, 1e300), choice("distance", distance, DISTANCES)
    )
    return to_array(field).copy()
