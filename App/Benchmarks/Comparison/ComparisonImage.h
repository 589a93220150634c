#ifndef Varimarch_Benchmarks_Comparison_ComparisonImage_h
#define Varimarch_Benchmarks_Comparison_ComparisonImage_h

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkTextureObject.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace varimarch
{

/// An image of four floats per pixel that a comparison method blends its parts in.
class ComparisonImage
{
public:
  /// Binds the image with its size and a colour in all pixels.
  /// @param depth  a depth buffer of the same size, or null
  /// @throws std::runtime_error if OpenGL has no such framebuffer
  void Begin(vtkOpenGLRenderWindow* window, glm::ivec2 size, const glm::vec4& color,
    vtkTextureObject* depth = nullptr);

  /// Binds the image again, with its present pixels.
  void Continue(vtkOpenGLRenderWindow* window);

  vtkTextureObject* Color() { return this->color; }
  std::size_t Bytes() const; ///< 0 before the first Begin
  void Release(vtkWindow* window);

private:
  glm::ivec2 size = glm::ivec2(0);
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  vtkNew<vtkTextureObject> color;
};

/// The blending of what is drawn with what is there; colours are premultiplied.
enum class ComparisonBlending
{
  Replace,
  Over,  ///< over what is there, as from the back to the front
  Under, ///< under what is there, as from the front to the back
  Dim,   ///< dims what is there by the opacity of what is drawn
};

/// Sets the state in which comparison methods draw: that blending, both sides of triangles, no
/// depth test.
void SetComparisonState(vtkOpenGLRenderWindow* window, ComparisonBlending blending);

}

#endif
