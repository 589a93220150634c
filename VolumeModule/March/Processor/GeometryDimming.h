#ifndef Varimarch_March_Processor_GeometryDimming_h
#define Varimarch_March_Processor_GeometryDimming_h

#include "March/Device/BoxDrawing.h"
#include "March/Processor/PacketPicture.h"

namespace varimarch
{

/// Lets opaque geometry receive the shadows of a volume: before the volume is drawn, the colours of
/// the geometry in the framebuffer are multiplied by what the volume leaves of their light. Packets
/// of rays find it on the processor.
class GeometryDimming
{
public:
  GeometryDimming(SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  /// Draws into the current framebuffer if the frame has shadows and geometry in them, and nobody
  /// interacts: there may be as many pixels of geometry as of the volume.
  /// @param plan  a plan of packets
  void Draw(const Frame& frame, const MarchPlan& plan);

  std::size_t Bytes() const { return this->factors.Bytes(); }
  void Release(vtkWindow* window) { this->factors.Release(window); }

private:
  SceneResources& resources;
  BoxDrawing& boxes;
  PacketPicture factors;
};

}

#endif
