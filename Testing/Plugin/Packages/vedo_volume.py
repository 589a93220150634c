"""vedo draws a volume. Usage: vedo_volume.py VOLUME.vti PICTURE.png"""

import sys

import vedo

plotter = vedo.Plotter(offscreen=True, size=(200, 200))
plotter.show(vedo.Volume(sys.argv[1]))
plotter.screenshot(sys.argv[2])
