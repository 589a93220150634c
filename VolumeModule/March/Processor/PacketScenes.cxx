#include "March/Processor/PacketScenes.h"

#include <algorithm>
#include <utility>

namespace varimarch
{

namespace
{

// Moves the depths of visible parts from the rays to the volume: rays through several volumes are
// not bounded by the visible parts of one.
void TakeDepths(PacketScene& scene)
{
  scene.constituent.visible = scene.depths;
  scene.depths = {};
}

PacketSurroundings SurroundingsOfOther(const Frame& frame, const VolumeResources& volume)
{
  PacketSurroundings around = {};
  around.drawnBox = frame.geometry.boxGrid;
  around.textures.clippingPlanes = volume.ClippingPlanes();
  return around;
}

}

PacketScenes::PacketScenes(const VolumeMarch& march, SceneResources& resources,
  PacketSurroundings around, const Viewport& pixels)
  : first(march, resources.First(), std::move(around), pixels)
{
  if (IsMixture(march.frame))
  {
    this->Mix(march, resources, pixels);
  }
  else if (march.frame.blockLevels)
  {
    this->AddCoarser(march, resources, pixels);
  }
}

// Rays are bounded by the parts of the voxels that are visible, not by those of the levels.
void PacketScenes::AddCoarser(
  const VolumeMarch& march, SceneResources& resources, const Viewport& pixels)
{
  this->levels = { &this->first.scene };
  for (std::size_t i = 0; i < march.frame.coarser.size(); ++i)
  {
    const VolumeMarch level = MarchOfCoarser(march.frame, march.plan, i);
    VolumeResources& volume = resources.Coarser(i);
    PacketSurroundings around = SurroundingsOfOther(level.frame, volume);
    around.textures.noiseTexture = this->first.around.textures.noiseTexture;
    around.textures.casterTree = this->first.around.textures.casterTree;
    PacketScene& scene = this->coarser.emplace_back(level, volume, std::move(around), pixels).scene;
    scene.depths = {};
    scene.parameters.ownGridFromRays = GridFromGrid(level.frame.geometry, march.frame.geometry);
    scene.levels.voxelGridFromOwn = GridFromGrid(march.frame.geometry, level.frame.geometry);
    this->levels.push_back(&scene);
  }
  const BlockLevels& blocks = *march.frame.blockLevels;
  const PacketLevels all = { this->levels.data(), int(this->levels.size()), glm::mat4(1.0f),
    blocks.ofBlocks.data(), blocks.count, float(blocks.side) };
  this->first.scene.levels = all;
  for (SceneOfVolume& level : this->coarser)
  {
    const glm::mat4 voxelGridFromOwn = level.scene.levels.voxelGridFromOwn;
    level.scene.levels = all;
    level.scene.levels.voxelGridFromOwn = voxelGridFromOwn;
  }
}

void PacketScenes::Mix(const VolumeMarch& march, SceneResources& resources, const Viewport& pixels)
{
  const Frame& frame = march.frame;
  std::vector<PacketScene> own = ConstituentsOf(march, resources.First(), this->first.scene);
  for (PacketScene& scene : own)
  {
    if (!frame.others.empty())
    {
      TakeDepths(scene);
    }
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    const VolumeMarch other = MarchOfOther(frame, march.plan, i);
    VolumeResources& volume = resources.Other(i);
    this->others.emplace_back(other, volume, SurroundingsOfOther(other.frame, volume), pixels);
    for (PacketScene& scene : ConstituentsOf(other, volume, this->others.back().scene))
    {
      scene.parameters.ownGridFromRays = GridFromGrid(other.frame.geometry, frame.geometry);
      TakeDepths(scene);
      this->mixed.push_back(scene);
    }
  }
  this->mixed.insert(this->mixed.end(), own.begin() + 1, own.end());
  const auto castsShadows = [](const PacketScene& scene) { return scene.light.castsShadows; };
  const bool isInShadow = std::any_of(this->mixed.begin(), this->mixed.end(), castsShadows);
  this->first.scene = own.front();
  this->first.scene.light.castsShadows |= isInShadow;
  this->first.scene.constituent.others = this->mixed.data();
  this->first.scene.constituent.otherCount = int(this->mixed.size());
}

}
