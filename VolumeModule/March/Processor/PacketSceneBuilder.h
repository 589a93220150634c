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

/// The part of a frame that packets of rays read beside its volume.
struct PacketSurroundings
{
  Box drawnBox;                      ///< The box that rays are marched through [grid space].
  std::vector<glm::vec4> planesGrid; ///< The planes that clip.
  const float* depth;                ///< The depths of geometry; null if there is none.
  glm::ivec2 depthPixels;            ///< The size of the image of depths.
  std::vector<float> layerDepths; ///< Slots.glsl's PeeledDepths of each pixel, if there are layers.
  LightTexels lights;
  std::vector<PacketRow> maskRows; ///< The tables of labels.
  std::vector<glm::vec4> isosurfaces;
  const std::uint16_t* noise; ///< The tile of blue noise; null without jitter.
};

/// The tables of the labels of a mask.
std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables);

/// A march in plain numbers, which point into the frame, its resources and its surroundings.
PacketScene PacketSceneOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketSurroundings& around);

/// The scene of a volume with its surroundings. Its depths of visible parts are overwritten by the
/// next scene of the same volume.
struct SceneOfVolume
{
  /// @param pixels  the pixels of the frame that are drawn
  SceneOfVolume(const VolumeMarch& march, VolumeResources& volume, PacketSurroundings newAround,
    const Viewport& pixels);

  PacketSurroundings around;
  PacketScene scene;
};

/// The look of a component's values by one of the volume's tables.
PacketLook LookOf(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeParameters& parameters, std::size_t table, int component);

/// True if packets march a frame as a mixture: several components, several volumes, or voxels at
/// uneven places, for which plain marches have no code.
bool IsMixture(const Frame& frame);

/// The scenes of a volume in a mixture, one for each of its materials.
/// @param scene  the scene of the volume as a whole
std::vector<PacketScene> ConstituentsOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketScene& scene);

}

#endif
