#ifndef Varimarch_AccumulatedPictures_h
#define Varimarch_AccumulatedPictures_h

#include "FloatFramebuffer.h"

#include <glm/vec2.hpp>

#include <vector>

namespace varimarch
{

/// The sum of several pictures of a scene that stays as it is, each by other rays through the same
/// pixels: their mean is smooth where one ray per pixel is jagged.
class AccumulatedPictures
{
public:
  /// To be called before each picture; forgets those of another scene.
  /// @param scene  all that a picture depends on
  void Begin(const std::vector<double>& scene);

  int Count() const { return this->count; }

  /// Where in its pixel each ray of the next picture is, from the middle [pixels]; that of the
  /// first is there.
  glm::dvec2 NextOffsetPixels() const;

  /// Calls `draw` with a framebuffer bound to which it is to add its picture, as large as `pixels`,
  /// whose origin is (0, 0).
  /// @throws std::runtime_error when OpenGL has no framebuffer of floats
  void Add(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  vtkTextureObject* Sum() const { return this->sum.Texture(); }
  std::size_t Bytes() const { return this->sum.Bytes(); }
  void Release(vtkWindow* window);

private:
  std::vector<double> scene;
  int count = 0;
  FloatFramebuffer sum;
};

}

#endif
