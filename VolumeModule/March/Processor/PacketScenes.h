#ifndef Varimarch_March_Processor_PacketScenes_h
#define Varimarch_March_Processor_PacketScenes_h

#include "March/Processor/PacketSceneBuilder.h"
#include "Resources/SceneResources.h"

#include <deque>
#include <vector>

namespace varimarch
{

/// The scene that packets march for a frame: a single volume, or a mixture of several components
/// and volumes along rays in the grid of the first volume. Some blocks of a single volume may be
/// drawn by its coarser levels. The parts point to each other.
class PacketScenes
{
public:
  /// @param around  the surroundings of the first volume
  /// @param pixels  the drawn pixels of the viewport
  PacketScenes(const VolumeMarch& march, SceneResources& resources, PacketSurroundings around,
    const Viewport& pixels);

  PacketScenes(const PacketScenes&) = delete;
  void operator=(const PacketScenes&) = delete;

  const PacketScene& Scene() const { return this->first.scene; }
  const std::vector<float>& LayerDepths() const { return this->first.around.layerDepths; }

private:
  void Mix(const VolumeMarch& march, SceneResources& resources, const Viewport& pixels);
  void AddCoarser(const VolumeMarch& march, SceneResources& resources, const Viewport& pixels);

  SceneOfVolume first;
  std::deque<SceneOfVolume> coarser;      ///< The coarser levels.
  std::vector<const PacketScene*> levels; ///< The scenes of all levels.
  std::vector<SceneOfVolume> others;      ///< The other volumes.
  std::vector<PacketScene> mixed;         ///< The parts of the mixture after the first.
};

}

#endif
