#ifndef Varimarch_March_ImageAccumulator_h
#define Varimarch_March_ImageAccumulator_h

#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "March/ImageSum.h"
#include "March/ResampledMarch.h"

#include <cstddef>

namespace varimarch
{

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
