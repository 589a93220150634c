#ifndef Varimarch_March_ResampledMarch_h
#define Varimarch_March_ResampledMarch_h

#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "Resources/FloatFramebuffer.h"

#include <cstddef>

namespace varimarch
{

/// Draws an image with fewer or more rays than pixels. The rays are drawn into a framebuffer of
/// their own; the pixels are then interpolated between rays, or averaged.
class ResampledMarch
{
public:
  ResampledMarch(const SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  void Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);

  std::size_t Bytes() const { return this->rays.Bytes(); }
  void Release(vtkWindow* window) { this->rays.Release(window); }

private:
  const SceneResources& resources;
  BoxDrawing& boxes;
  FloatFramebuffer rays;
};

}

#endif
