#ifndef Varimarch_March_Processor_PacketSceneBuilder_h
#define Varimarch_March_Processor_PacketSceneBuilder_h

#include "Core/Packets/PacketScene.h"
#include "Resources/SceneResources.h"
#include "Resources/VolumeResources.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <deque>
#include <vector>

namespace varimarch
{

/// The data of a frame that packets of rays read besides its volume.
struct PacketSurroundings
{
  Box drawnBox; ///< The box that rays are marched through [grid space].
  RayTextures textures;
  glm::ivec2 depthPixels;           ///< The size of the image of depths.
  std::vector<float> trialDepths;   ///< The depth image of a trial image's rays; may be empty.
  std::vector<float> layerDepths;   ///< PeeledDepths of Slots.glsl for each pixel; may be empty.
  std::vector<PacketRow> labelRows; ///< The tables of labels.
};

/// The tables of the labels of a mask.
std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables, const TexelMapping& mapping);

/// The scene of a march. It points into the frame, its resources and its surroundings.
PacketScene PacketSceneOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketSurroundings& around);

/// The scene of a volume together with its surroundings. The next scene of the same volume
/// overwrites its depths of visible parts.
struct SceneOfVolume
{
  /// @param pixels  the drawn pixels of the frame
  SceneOfVolume(const VolumeMarch& march, VolumeResources& volume, PacketSurroundings newAround,
    const Viewport& pixels);

  PacketSurroundings around;
  PacketScene scene;
};

/// The look of a component's values, from one of the volume's tables.
PacketLook LookOf(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeParameters& parameters, std::size_t table, int component);

/// True if packets march a frame as a mixture. This holds for several components, several volumes,
/// and unevenly spaced voxels, which plain marches do not support.
bool IsMixture(const Frame& frame);

/// The scenes of a volume in a mixture, one for each of its materials.
/// @param scene  the scene of the whole volume
std::vector<PacketScene> ConstituentsOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketScene& scene);

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
