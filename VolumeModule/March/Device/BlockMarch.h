#ifndef Varimarch_March_Device_BlockMarch_h
#define Varimarch_March_Device_BlockMarch_h

#include "March/Device/BoxDrawing.h"
#include "Resources/RayAccumulation.h"
#include "Resources/SceneResources.h"

#include <cstddef>
#include <functional>
#include <utility>

namespace varimarch
{

/// Marches a volume that is divided into blocks, from front to back: each block continues the sums
/// that the rays have gathered. A last drawing turns these sums into pixels.
class BlockMarch
{
public:
  /// @param ofImages  returns the memory that framebuffers take at present
  BlockMarch(
    SceneResources& resources, BoxDrawing& boxes, std::function<MemoryElsewhere()> ofImages)
    : resources(resources)
    , boxes(boxes)
    , ofImages(std::move(ofImages))
  {
  }

  void Draw(const Frame& frame, const MarchPlan& plan);

  std::size_t Bytes() const { return this->accumulation.Bytes(); }
  void Release(vtkWindow* window) { this->accumulation.Release(window); }

private:
  void DrawBlock(const Frame& frame, MarchPlan plan, int block);

  SceneResources& resources;
  BoxDrawing& boxes;
  std::function<MemoryElsewhere()> ofImages;
  RayAccumulation accumulation;
};

}

#endif
