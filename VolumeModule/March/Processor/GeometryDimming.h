#ifndef Varimarch_March_Processor_GeometryDimming_h
#define Varimarch_March_Processor_GeometryDimming_h

#include "March/Device/BoxDrawing.h"
#include "March/Processor/PacketPicture.h"
#include "Resources/FloatFramebuffer.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// Lets opaque geometry receive the shadows of a volume: before the volume is drawn, the colours of
/// the geometry in the framebuffer are multiplied by what the volume leaves of their light. The
/// processor finds the places that are seen. Whoever marches the volume traces the lights from
/// there: packets of rays or a shader.
class GeometryDimming
{
public:
  GeometryDimming(SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  /// Draws into the current framebuffer if the frame has shadows and geometry that may receive
  /// them, and nobody interacts: there may be as many pixels of geometry as of the volume.
  void Draw(const Frame& frame, const MarchPlan& plan);

  std::size_t Bytes() const { return this->image.Bytes() + this->light.Bytes(); }
  void Release(vtkWindow* window);

private:
  bool MayDim(const Frame& frame, const MarchPlan& plan) const;
  std::vector<std::vector<float>> LightByPackets(
    const Frame& frame, const MarchPlan& plan, const std::vector<glm::vec4>& places);
  std::vector<std::vector<float>> LightByShader(const Frame& frame, const MarchPlan& plan,
    const std::vector<glm::vec4>& places, const Box& coverGrid);

  SceneResources& resources;
  BoxDrawing& boxes;
  PacketPicture image;         ///< First places, then factors.
  FloatFramebuffer light{ 2 }; ///< The light on places, by a shader.
};

}

#endif
