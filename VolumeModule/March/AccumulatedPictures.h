#ifndef Varimarch_March_AccumulatedPictures_h
#define Varimarch_March_AccumulatedPictures_h

#include "Core/Quality/PictureStrips.h"
#include "Resources/FloatFramebuffer.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <vector>

namespace varimarch
{

/// The sum of several pictures of a scene that stays as it is, each by other rays through the same
/// pixels: their mean is smooth where one ray per pixel is jagged. A picture that takes long may be
/// added strip by strip.
class AccumulatedPictures
{
public:
  /// To be called before each picture; forgets those of another scene.
  /// @param scene  all that a picture depends on
  void Begin(const std::vector<double>& scene);

  /// Those of which all is there.
  int Count() const { return this->count; }
  /// And so many rows of the next one, from below.
  int RowsOfNext() const { return this->strips.Done(); }
  double CountWithParts() const
  {
    return this->count + double(this->RowsOfNext()) / std::max(this->pictureRows, 1);
  }
  bool IsEmpty() const { return this->count == 0 && this->RowsOfNext() == 0; }

  /// Where in its pixel each ray of the next picture is, from the middle [pixels]; that of the
  /// first is there.
  glm::dvec2 NextOffsetPixels() const;

  /// Whether a picture would be added in several strips.
  bool IsDivided(const Viewport& pixels) const { return this->strips.IsDivided(pixels.height); }

  /// Calls `draw` for what is seen where nothing has been added yet.
  void Begin(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Calls `draw` with a framebuffer bound to which it is to add its picture, as large as `pixels`,
  /// whose origin is (0, 0); what is not in the strip is left out.
  /// @param longestSeconds  that a strip is to take; 0: all that is left of the picture is added
  /// @throws std::runtime_error when OpenGL has no framebuffer of floats
  void Add(vtkOpenGLRenderWindow* window, const Viewport& pixels, double longestSeconds,
    const std::function<void()>& draw);

  vtkTextureObject* Sum() const { return this->sum.Texture(); }
  std::size_t Bytes() const { return this->sum.Bytes(); }
  void Release(vtkWindow* window);

private:
  std::vector<double> scene;
  int count = 0;
  int pictureRows = 0;
  PictureStrips strips; ///< of the next one
  FloatFramebuffer sum;
};

}

#endif
