#ifndef Varimarch_March_ImageSum_h
#define Varimarch_March_ImageSum_h

#include "Core/Quality/PictureStrips.h"
#include "Resources/FloatFramebuffer.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <vector>

namespace varimarch
{

/// The sum of several images of a scene that stays as it is, each by other rays through the same
/// pixels: their mean is smooth where one ray per pixel is jagged. An image that takes long may be
/// added strip by strip.
class ImageSum
{
public:
  /// Must be called before each image; forgets the images of another scene.
  /// @param scene  everything that an image depends on
  void Begin(const std::vector<double>& scene);

  /// The images that are complete.
  int Count() const { return this->count; }
  /// The rows of the next image that have been added, from below.
  int RowsOfNext() const { return this->strips.Done(); }
  double CountWithParts() const
  {
    return this->count + double(this->RowsOfNext()) / std::max(this->imageRows, 1);
  }
  bool IsEmpty() const { return this->count == 0 && this->RowsOfNext() == 0; }

  /// The place of each ray of the next image, from the middle of its pixel [pixels]. The rays of
  /// the first are in the middle.
  glm::dvec2 NextOffsetPixels() const;

  /// True if an image would be added in several strips.
  bool IsDivided(const Viewport& pixels) const { return this->strips.IsDivided(pixels.height); }

  /// Calls `draw` for an image that shows where nothing has been added yet.
  void Begin(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Calls `draw` with a framebuffer bound to which it must add its image, as large as `pixels`,
  /// whose origin is (0, 0). Only the pixels of the strip are drawn.
  /// @param longestSeconds  the time for a strip; 0 adds all that is left of the image
  /// @throws std::runtime_error if OpenGL has no framebuffer of floats
  void Add(vtkOpenGLRenderWindow* window, const Viewport& pixels, double longestSeconds,
    const std::function<void()>& draw);

  vtkTextureObject* Texture() const { return this->sum.Texture(); }
  std::size_t Bytes() const { return this->sum.Bytes(); }
  void Release(vtkWindow* window);

private:
  std::vector<double> scene;
  int count = 0;
  int imageRows = 0;
  PictureStrips strips; ///< The strips of the next image.
  FloatFramebuffer sum;
};

}

#endif
