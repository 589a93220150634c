#ifndef Varimarch_Resources_SceneDepthTexture_h
#define Varimarch_Resources_SceneDepthTexture_h

#include "Core/Parameters/MarchTextures.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A copy of the depth buffer, made when the volume is drawn. The buffer itself cannot be read: it
/// is bound for drawing, may be multisampled, and may belong to a render pass.
class SceneDepthTexture
{
public:
  /// Copies a rectangle of the framebuffer that is bound for drawing [pixels].
  void Capture(vtkOpenGLRenderWindow* window, int left, int bottom, int width, int height);

  /// Reads the captured depths from the device into memory, unless they are there.
  void Read(vtkOpenGLRenderWindow* window);

  /// The depths; in memory row by row from the bottom, as floats.
  MarchTexture Texture() const
  {
    return { this->depth, this->depths.empty() ? nullptr : this->depths.data() };
  }
  glm::ivec2 SizePixels() const
  {
    return glm::ivec2(this->depth->GetWidth(), this->depth->GetHeight());
  }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  unsigned int format = 0; ///< The format of the framebuffer that was copied last.
  vtkNew<vtkTextureObject> depth;
  vtkNew<vtkTextureObject> color; ///< Unused, but a complete framebuffer needs it.
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  std::vector<float> depths; ///< The result of Read(); empty until it is called.
  std::size_t bytes = 0;
};

}

#endif
