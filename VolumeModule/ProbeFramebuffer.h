#ifndef Varimarch_ProbeFramebuffer_h
#define Varimarch_ProbeFramebuffer_h

#include "VolumeGeometry.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"

#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A small framebuffer of floats, in which a picture is tried out with a part of its rays.
class ProbeFramebuffer
{
public:
  /// Its size for pictures of a size [pixels]: enough rays to show the 99.9th percentile of an
  /// error, in two tiles of a software rasteriser, so that two cores share the work.
  static Viewport PixelsFor(const Viewport& picture);

  /// Calls `draw` with this framebuffer bound, cleared to nothing, and returns what it drew:
  /// premultiplied RGBA.
  std::vector<float> Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, const Viewport& pixels);

  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  int width = 0;
  int height = 0;
  std::size_t bytes = 0;
};

}

#endif
