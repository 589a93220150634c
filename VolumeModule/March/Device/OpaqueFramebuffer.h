#ifndef Varimarch_March_Device_OpaqueFramebuffer_h
#define Varimarch_March_Device_OpaqueFramebuffer_h

#include "VtkVersions.h"

#include "vtkOpenGLState.h"

class vtkRenderer;

namespace varimarch
{

/// A scope in which the framebuffer with the colours and depths of opaque geometry is bound, in the
/// middle of a pass that peels depths into a framebuffer of its own. VTK keeps the other one on the
/// stack of its state until it blends the layers over it.
class OpaqueFramebuffer
{
public:
  explicit OpaqueFramebuffer(vtkRenderer* renderer);
  ~OpaqueFramebuffer();
  OpaqueFramebuffer(const OpaqueFramebuffer&) = delete;
  void operator=(const OpaqueFramebuffer&) = delete;

private:
  vtkOpenGLState* state;
  vtkOpenGLState::ScopedglViewport viewport;
  GLint layers = 0; ///< The framebuffer of the layers.
  GLint blendEquation = 0;
};

}

#endif
