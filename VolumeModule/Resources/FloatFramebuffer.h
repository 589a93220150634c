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

/// A texture of four floats per pixel that is drawn to in the window's place and read afterwards,
/// or several that are drawn to at once.
class FloatFramebuffer
{
public:
  /// @param outputs  textures, one for each of a shader's outputs
  explicit FloatFramebuffer(int outputs = 1);

  /// The memory of an image of this size, for each output.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Calls `draw` with this bound as framebuffer and cleared. It covers `pixels`, whose
  /// origin is (0, 0); the texture only ever grows.
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
