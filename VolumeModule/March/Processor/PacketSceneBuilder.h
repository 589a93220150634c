#ifndef Varimarch_March_Processor_PacketSceneBuilder_h
#define Varimarch_March_Processor_PacketSceneBuilder_h

#include "Core/Packets/PacketScene.h"
#include "Frame/Lights.h"
#include "Resources/VolumeResources.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// What packets of rays see of a frame beside its volume.
struct PacketSurroundings
{
  Box drawnBox;                      ///< where rays are marched [grid space]
  std::vector<glm::vec4> planesGrid; ///< that clip
  const float* depth;                ///< none: there is no geometry
  glm::ivec2 depthPixels;            ///< its size
  std::vector<float> layerDepths;    ///< Slots.glsl's PeeledDepths of each pixel; none: no layers
  LightTexels lights;
  std::vector<PacketRow> maskRows; ///< of labels
  std::vector<glm::vec4> isosurfaces;
  const std::uint16_t* noise; ///< BlueNoiseTile; none: without jitter
};

/// What the labels of a mask look like.
std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables);

/// A frame in plain numbers, which point into all three.
PacketScene PacketSceneOf(
  const Frame& frame, const VolumeResources& volume, const PacketSurroundings& around);

/// The same with what it points into, but for where it is visible: until the volume's next one is
/// made.
struct SceneOfVolume
{
  /// @param pixels  that are drawn of the frame's
  SceneOfVolume(const Frame& frame, VolumeResources& volume, PacketSurroundings newAround,
    const Viewport& pixels);

  PacketSurroundings around;
  PacketScene scene;
};

/// The look of a component's values by one of the volume's tables.
PacketLook LookOf(const Frame& frame, const VolumeResources& volume,
  const VolumeParameters& parameters, std::size_t table, int component);

/// Whether what packets march is a mixture: several components, several volumes, or voxels at
/// uneven places, for which plain marches have no code.
bool IsMixture(const Frame& frame);

/// What a volume adds to a mixture: one scene for each of the materials that it has.
/// @param scene  of the frame
std::vector<PacketScene> ConstituentsOf(
  const Frame& frame, const VolumeResources& volume, const PacketScene& scene);

/// All constituents of a mixture but the first, which points to them.
struct MixedScenes
{
  std::vector<SceneOfVolume> volumes; ///< beside the first
  std::vector<PacketScene> scenes;    ///< of components and of these
};

}

#endif
