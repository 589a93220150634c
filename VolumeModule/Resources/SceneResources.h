#ifndef Varimarch_Resources_SceneResources_h
#define Varimarch_Resources_SceneResources_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/TriangleTree.h"
#include "Core/Parameters/MarchTextures.h"
#include "Frame/Frame.h"
#include "Frame/MarchPlan.h"
#include "Frame/ShadowCasters.h"
#include "Resources/BlueNoiseTexture.h"
#include "Resources/FloatTable.h"
#include "Resources/SceneDepthTexture.h"
#include "Resources/VolumeResources.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace varimarch
{

/// The opaque geometry that casts shadows on a volume, as a TriangleTree. The tree is made again
/// when the data of the geometry change. Where only matrices do, the triangles of these surfaces
/// are moved in it.
class CasterResources
{
public:
  /// @throws std::runtime_error if the device cannot hold so many triangles
  void Update(const Frame& frame, Marcher marcher);

  /// The tree; null without geometry.
  MarchTexture Tree() const;
  /// The places of its triangles in the data.
  const std::vector<SurfaceTriangle>& Sources() const { return this->sources; }
  std::size_t Bytes() const { return this->texture.Bytes(); } ///< Its graphics memory.
  void Release(vtkWindow* window);

private:
  bool Move(const ShadowCasters& casters);
  void Make(const ShadowCasters& casters);

  ShadowCasters made; ///< The geometry in the tree; its data may be gone.
  std::optional<TriangleTree> tree;
  FloatBufferTexture texture; ///< The tree for the device.
  std::vector<SurfaceTriangle> sources;
};

/// Everything that the march of a frame reads: the resources of its volumes, the depth of opaque
/// geometry, and the noise of jitter.
class SceneResources
{
public:
  /// Updates the voxels of all volumes.
  void UpdateVoxels(const Frame& frame);

  /// Updates everything else, except the pre-integrated table, and adds the volumes' findings to
  /// the plan.
  /// @param ofImages  the memory of framebuffers
  /// @throws std::runtime_error if the device cannot hold a resource
  void Update(const Frame& frame, MarchPlan& plan, const MemoryElsewhere& ofImages);

  /// Makes the pre-integrated table if the plan's integration rule needs it.
  void UpdatePreIntegrated(const Frame& frame, const MarchPlan& plan);

  /// Begins an image of a volume in blocks, which must then be taken in the given order.
  void BeginPicture(
    const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& ofImages);

  VolumeResources& First() { return this->first; }
  const VolumeResources& First() const { return this->first; }
  VolumeResources& Other(std::size_t index) { return *this->others[index]; }
  const VolumeResources& Other(std::size_t index) const { return *this->others[index]; }
  /// A coarser level. Requires a frame that has it.
  VolumeResources& Coarser(std::size_t level) { return *this->coarser[level]; }
  SceneDepthTexture& Depth() { return this->depth; }
  const CasterResources& Casters() const { return this->casters; }
  /// The textures of the rays, apart from results of other drawings.
  RayTextures Textures() const;

  bool AnyFits8Bits() const; ///< True if texels of 8 bits can hold a volume.
  bool IsInBlocks() const { return this->first.Blocks().Partition().Count() > 1; }
  /// True if the device cannot hold volumes that overlap.
  bool IsTooLarge() const;
  /// @throws std::runtime_error if volumes that overlap cannot be drawn as planned
  void CheckOverlap(const MarchPlan& plan) const;
  /// The box around all volumes through which rays are marched, in the grid of the first volume.
  const Box& DrawnBox() const { return this->drawnBox; }
  bool IsNothingDrawn() const;
  std::size_t LightBytes() const; ///< The main memory of the lattices of light.
  int LightLatticeBuilds() const; ///< How many lattices of light were begun.
  bool MissesCurve() const;       ///< True if a table of any volume misses a curve of its function.
  /// True if texels do not tell apart the values that matter. Overlapping volumes are no
  /// projection.
  bool MergesValues() const { return this->first.Materials().MergesValues(); }
  std::size_t Bytes() const { return this->first.Bytes() + this->BytesBesideFirst(); }
  void Release(vtkWindow* window);

private:
  void UpdateDepth(const Frame& frame, const MarchPlan& plan);
  void UpdateNoise(const Frame& frame, const MarchPlan& plan);
  void UpdateOthers(const Frame& frame, MarchPlan& plan);
  Box BoxOfAll(const Frame& frame) const;
  /// The sum over the volumes that overlap.
  template <class Number>
  Number SumOfLight(Number (LightResources::*number)() const) const;
  std::size_t BytesBesideFirst() const;
  MemoryElsewhere BesideFirst(const MemoryElsewhere& ofImages) const;

  VolumeResources first;
  std::vector<std::unique_ptr<VolumeResources>>
    others; ///< The volumes that overlap with the first.
  std::vector<std::unique_ptr<VolumeResources>> coarser; ///< The coarser levels.
  SceneDepthTexture depth;
  BlueNoiseTexture noise;
  CasterResources casters;
  Box drawnBox = {};
};

}

#endif
