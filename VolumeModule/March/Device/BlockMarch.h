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

/// Marches a volume that is in several blocks: from front to back, each into what the rays have
/// gathered so far. A last drawing makes pixels of that.
class BlockMarch
{
public:
  /// @param ofImages  returns the memory that framebuffers take now
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
