"""PyVista draws a volume with Varimarch.

Usage: pyvista_volume.py PICTURE.png
"""
import sys

import pyvista
import varimarch

varimarch.enable()
plotter = pyvista.Plotter(off_screen=True)
plotter.add_volume(pyvista.Wavelet(), cmap="viridis", opacity="sigmoid", opacity_unit_distance=2.0)
plotter.show(screenshot=sys.argv[1])
