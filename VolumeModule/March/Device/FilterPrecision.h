#ifndef Varimarch_March_Device_FilterPrecision_h
#define Varimarch_March_Device_FilterPrecision_h

#include "VarimarchVolumeModule.h"

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// True if the device filters 3D textures of 8 bits as exactly as those of 16. OpenGL does not say
/// how exact a filter is, and some devices filter numbers of 8 bits in 8 bits, with errors of a
/// grey level. The first call on a device and its driver draws a small image to find out; later
/// ones remember.
/// @throws std::runtime_error if OpenGL has no framebuffer of floats
VARIMARCHVOLUME_EXPORT bool Filters8BitsExactly(vtkOpenGLRenderWindow* window);

/// The largest difference between the same voxels filtered in texels of 8 and of 16 bits, as a
/// fraction of the largest texel. Draws each time.
VARIMARCHVOLUME_EXPORT double LargestFilterDifference(vtkOpenGLRenderWindow* window);

}

#endif
