#ifndef Varimarch_March_Device_GraphicsDriver_h
#define Varimarch_March_Device_GraphicsDriver_h

#include "VarimarchVolumeModule.h"

#include "vtkCommand.h"

#include <stdexcept>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// True if the device filters 3D textures of 8 bits as exactly as those of 16. OpenGL does not say
/// how exact a filter is, and some devices filter numbers of 8 bits in 8 bits, with errors of a
/// grey level. The first call on a device and its driver draws a small image to find out; later
/// ones remember.
/// @throws std::runtime_error if OpenGL has no framebuffer of floats
VARIMARCHVOLUME_EXPORT bool Filters8BitsExactly(vtkOpenGLRenderWindow* window);

/// True if the device interpolates between texels with weights that are as good as exact. Graphics
/// cards round them, most of them to parts of 2^-8, which shows where a transfer function is steep.
/// The first call on a device and its driver draws a small image to find out; later ones remember.
/// @throws std::runtime_error if OpenGL has no framebuffer of floats
VARIMARCHVOLUME_EXPORT bool FiltersBetweenTexelsExactly(vtkOpenGLRenderWindow* window);

/// The largest difference between the same voxels filtered in texels of 8 and of 16 bits, as a
/// fraction of the largest texel. Draws each time.
VARIMARCHVOLUME_EXPORT double LargestNarrowDifference(vtkOpenGLRenderWindow* window);

/// The largest difference between voxels filtered by the device and with exact weights, as a
/// fraction of the largest texel. Draws each time.
VARIMARCHVOLUME_EXPORT double LargestWeightDifference(vtkOpenGLRenderWindow* window);

/// The event of a mapper whose frame is lost because the graphics card was reset. Its graphics
/// resources and the window's context are lost too: only a new context draws again.
constexpr unsigned long GraphicsResetEvent = vtkCommand::UserEvent + 1;

/// The reason why a frame is lost, in one sentence.
class GraphicsReset : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Checks the current context, as far as the driver can tell. A driver tells each reset once.
/// @throws GraphicsReset if the graphics card was reset, so that what was drawn is lost
void CheckForGraphicsReset();

/// True if the current OpenGL context is drawn by the processor, with llvmpipe.
bool IsSoftwareRasterizer();

/// A software rasteriser ends a shader, and with it the ray, after this many iterations of all its
/// loops.
constexpr int MostShaderIterations = 1 << 16;

}

#endif
