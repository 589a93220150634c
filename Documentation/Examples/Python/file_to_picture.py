"""A volume file seen from four sides, side by side.

Usage: file_to_picture.py VOLUME PICTURE.png [PRESET]
"""
import sys

import numpy
import varimarch

volume = varimarch.read(sys.argv[1])
values = varimarch.to_array(volume)
print(f"{values.shape[::-1]} voxels of {volume.GetSpacing()} mm, {values.min()} to {values.max()}")

preset = sys.argv[3] if len(sys.argv) > 3 else "mr-head"
views = ("right", "anterior", "left", "posterior")
pictures = [varimarch.render(volume, preset=preset, view=view, size=(256, 256)) for view in views]
varimarch.write_png(numpy.hstack(pictures), sys.argv[2])
