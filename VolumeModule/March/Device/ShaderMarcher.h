#ifndef Varimarch_March_Device_ShaderMarcher_h
#define Varimarch_March_Device_ShaderMarcher_h

#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/RayAccumulation.h"
#include "Resources/SceneResources.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

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

/// Marches rays with shaders, through a whole volume, a volume in blocks, or several volumes.
class ShaderMarcher : public FrameMarcher
{
public:
  /// @param ofImages  returns the memory that framebuffers take at present
  ShaderMarcher(
    SceneResources& resources, BoxDrawing& boxes, const std::function<MemoryElsewhere()>& ofImages)
    : resources(resources)
    , boxes(boxes)
    , blocks(resources, boxes, ofImages)
  {
  }

  void Draw(const Frame& frame, const MarchPlan& plan) override;
  std::vector<std::vector<float>> DrawTrials(
    const Frame& frame, const std::vector<MarchPlan>& plans) override;

  std::size_t BytesOfBlocks() const { return this->blocks.Bytes(); }
  void ReleaseBlocks(vtkWindow* window) { this->blocks.Release(window); }
  void ReleaseTrial(vtkWindow* window) { this->trial.Release(window); }
  std::size_t Bytes() const override { return this->trial.Bytes() + this->blocks.Bytes(); }
  void Release(vtkWindow* window) override;

private:
  SceneResources& resources;
  BoxDrawing& boxes;
  BlockMarch blocks;
  FloatFramebuffer trial;
};

}

#endif
