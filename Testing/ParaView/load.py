"""Tries to load a plugin that ParaView cannot use, and draws a volume all the same.

Usage: pvpython load.py PLUGIN
"""

import sys

from paraview import simple

try:
    simple.LoadPlugin(sys.argv[1], remote=True, ns=globals())
except RuntimeError as problem:
    print("refused:", problem)
simple.Show(simple.Wavelet()).SetRepresentationType("Volume")
simple.Render()
print("drawn")
