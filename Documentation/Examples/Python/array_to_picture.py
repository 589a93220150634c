"""An array in, a picture out: a ball of gel with a hard core.

Usage: array_to_picture.py PICTURE.png
"""
import sys

import numpy
import varimarch

z, y, x = numpy.mgrid[-1:1:100j, -1:1:100j, -1:1:100j]
distance = numpy.sqrt(x**2 + y**2 + z**2)
picture = varimarch.render(
    1 - distance,
    color=[(0.0, "steelblue"), (0.6, "steelblue"), (0.7, "orange")],
    opacity=[(0.0, 0.0), (0.1, 0.004), (0.6, 0.004), (0.7, 1.0)],
    view="anterior", azimuth=30, elevation=20, background="white",
)
varimarch.write_png(picture, sys.argv[1])
