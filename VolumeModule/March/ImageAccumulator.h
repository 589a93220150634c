#ifndef Varimarch_March_ImageAccumulator_h
#define Varimarch_March_ImageAccumulator_h

#include "Core/Quality/PictureStrips.h"
#include "Frame/Fingerprint.h"
#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "March/PassMarch.h"
#include "Resources/FloatFramebuffer.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>

namespace varimarch
{

/// The sum of several images of a scene that does not change, each with other rays through the same
/// pixels, so that their mean has smooth edges. An image that takes long may be added in strips.
class ImageSum
{
public:
  /// Must be called before each image; clears the sum if the scene has changed.
  /// @param scene  everything that an image depends on
  void Begin(const Fingerprint& scene);

  /// The number of complete images.
  int Count() const { return this->count; }
  /// The number of rows of the next image that have been added, from the bottom.
  int RowsOfNext() const { return this->strips.Done(); }
  double CountWithParts() const
  {
    return this->count + double(this->RowsOfNext()) / std::max(this->imageRows, 1);
  }
  bool IsEmpty() const { return this->count == 0 && this->RowsOfNext() == 0; }

  /// The offset of each ray of the next image from the centre of its pixel [pixels]; 0 in the first
  /// image.
  glm::dvec2 NextOffsetPixels() const;

  /// True if an image would be added in several strips.
  bool IsDivided(const Viewport& pixels) const { return this->strips.IsDivided(pixels.height); }

  /// Calls `draw` for an image that is visible where nothing has been added yet.
  void Begin(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Calls `draw`, which must add its image to the bound framebuffer. The framebuffer has the size
  /// of `pixels` and its origin at (0, 0); only the pixels of the strip are drawn.
  /// @param longestSeconds  the time for a strip; 0 adds the rest of the image
  /// @throws std::runtime_error if OpenGL has no framebuffer of floats
  void Add(vtkOpenGLRenderWindow* window, const Viewport& pixels, double longestSeconds,
    const std::function<void()>& draw);

  vtkTextureObject* Texture() const { return this->sum.Texture(); }
  std::size_t Bytes() const { return this->sum.Bytes(); }
  void Release(vtkWindow* window);

private:
  Fingerprint scene;
  int count = 0;
  int imageRows = 0;
  PictureStrips strips; ///< The strips of the next image.
  FloatFramebuffer sum;
};

/// Draws the mean of several images of a scene that does not change, adding one image per frame.
/// The first image is the same as without accumulation; later ones have shorter steps.
class ImageAccumulator
{
public:
  ImageAccumulator(const SceneResources& resources, BoxDrawing& boxes, ResampledMarch& resampled)
    : resources(resources)
    , boxes(boxes)
    , resampled(resampled)
  {
  }

  /// Decides whether a frame is accumulated, and the error budget of its next image.
  void Begin(const Frame& frame, MarchPlan& plan);

  /// Adds the next image, or a part of it, and draws the mean. Requires Begin().
  void Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);

  /// The number of images in the mean that was drawn last; 0 until the first is complete.
  int Images() const { return this->sum.IsEmpty() ? 1 : this->sum.Count(); }
  /// The fraction of this many images that is drawn, [0, 1].
  double DrawnPart(int mostImages) const;
  std::size_t Bytes() const { return this->sum.Bytes(); }
  void Release(vtkWindow* window) { this->sum.Release(window); }

private:
  void AddNext(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);
  void DrawBeneath(const Frame& frame, MarchPlan plan, FrameMarcher& marcher);
  void DrawMean(const Frame& frame, const MarchPlan& plan);

  const SceneResources& resources;
  BoxDrawing& boxes;
  ResampledMarch& resampled;
  ImageSum sum;
};

}

#endif
