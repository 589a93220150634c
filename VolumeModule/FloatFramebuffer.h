#ifndef Varimarch_FloatFramebuffer_h
#define Varimarch_FloatFramebuffer_h

#include "VolumeGeometry.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A texture of four floats per pixel that is drawn to in the window's place and read afterwards.
class FloatFramebuffer
{
public:
  /// What a picture of this size takes.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Calls `draw` with this bound as framebuffer and cleared to nothing. It covers `pixels`, whose
  /// origin is (0, 0); the texture only ever grows.
  /// @throws std::runtime_error when OpenGL has no framebuffer of floats
  void Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// The same, on what is there.
  void DrawMore(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// What is there after Draw: four floats for each of its pixels.
  std::vector<float> Read(vtkOpenGLRenderWindow* window, const Viewport& pixels);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, const Viewport& pixels);

  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  vtkNew<vtkTextureObject> texture;
};

}

#endif
