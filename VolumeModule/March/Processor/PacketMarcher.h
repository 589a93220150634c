#ifndef Varimarch_March_Processor_PacketMarcher_h
#define Varimarch_March_Processor_PacketMarcher_h

#include "Frame/Frame.h"
#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "March/Processor/PacketPicture.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/SceneResources.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// Marches packets of rays on the processor when OpenGL is software too. A shader then draws the
/// image, so that it is blended with the framebuffer in the same way as images of ShaderMarcher.
class PacketMarcher : public FrameMarcher
{
public:
  PacketMarcher(SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  void Draw(const Frame& frame, const MarchPlan& plan) override;
  std::vector<std::vector<float>> DrawTrials(
    const Frame& frame, const std::vector<MarchPlan>& plans) override;

  void ReleaseLayerDepths(vtkWindow* window) { this->layerDepths.Release(window); }
  std::size_t Bytes() const override { return this->image.Bytes() + this->layerDepths.Bytes(); }
  void Release(vtkWindow* window) override;

private:
  PacketSurroundings SurroundingsOf(const Frame& frame, const MarchPlan& plan);
  std::vector<float> DrawLayerDepths(const Frame& frame, const MarchPlan& plan);

  SceneResources& resources;
  BoxDrawing& boxes;
  PacketPicture image;
  FloatFramebuffer layerDepths; ///< The depths of the translucent layers around the rays.
};

/// True if packets of rays should march a frame if they can: where OpenGL is software, unless its
/// memory is bounded, and on any device a frame with shadows or ambient occlusion.
bool ShouldMarchByPackets(const Frame& frame);

/// True if packets of rays can march a frame: the request allows it, and packets have code for the
/// recipe and the voxels of every volume.
/// @param resources  the volumes, with up-to-date voxels
bool CanMarchByPackets(const Frame& frame, SceneResources& resources);

}

#endif
