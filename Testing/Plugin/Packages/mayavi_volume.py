"""mayavi draws a volume. Usage: mayavi_volume.py VOLUME.vti PICTURE.png"""

import sys

from mayavi import mlab

mlab.options.offscreen = True
figure = mlab.figure(size=(200, 200))
mlab.pipeline.volume(mlab.pipeline.open(sys.argv[1]))
# VTK's mapper draws the last one of several lights only.
for light in figure.scene.light_manager.lights[1:]:
    light.activate = False
mlab.savefig(sys.argv[2])
