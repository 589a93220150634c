#ifndef Varimarch_Resources_FloatFramebuffer_h
#define Varimarch_Resources_FloatFramebuffer_h

#include "Frame/VolumeGeometry.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A framebuffer of one or more textures with four floats per pixel, which replaces the window's
/// framebuffer during a drawing and can be read afterwards.
class FloatFramebuffer
{
public:
  /// @param outputs  number of textures, one for each output of the shader
  explicit FloatFramebuffer(int outputs = 1);

  /// The memory of an image of this size, per output.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Clears and binds this framebuffer, and calls `draw`. The framebuffer has the size of `pixels`
  /// and its origin at (0, 0); its textures only grow.
  /// @throws std::runtime_error if OpenGL has no framebuffer of floats
  void Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Does the same without clearing.
  void DrawMore(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Reads four floats for each pixel of the last Draw.
  std::vector<float> Read(vtkOpenGLRenderWindow* window, const Viewport& pixels, int output = 0);

  vtkTextureObject* Texture() const { return this->textures.front(); }
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, const Viewport& pixels);

  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  std::vector<vtkSmartPointer<vtkTextureObject>> textures;
};

}

#endif
