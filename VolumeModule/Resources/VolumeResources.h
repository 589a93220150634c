#ifndef Varimarch_Resources_VolumeResources_h
#define Varimarch_Resources_VolumeResources_h

#include "Core/Geometry/UnevenAxis.h"
#include "Frame/MarchPlan.h"
#include "Resources/FieldResources.h"
#include "Resources/FloatTable.h"
#include "Resources/LightResources.h"
#include "Resources/MaskTexture.h"
#include "Resources/MaterialResources.h"
#include "Resources/ProcessorVolume.h"
#include "Resources/SplineVolume.h"
#include "Resources/VolumeDivision.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The number of times that each resource of a volume was built.
struct VolumeBuilds
{
  int volumeTexture = 0; ///< Uploads of new scalars.
  int brickRanges = 0;
  int field = 0; ///< Builds of the field, except those for other ray directions only.
  int opticalTable = 0;

  int Sum() const
  {
    return this->volumeTexture + this->brickRanges + this->field + this->opticalTable;
  }
};

/// Owns everything that the march through one volume reads: its voxels, in blocks or in the form
/// for packets, the look of its values, its field, its mask and its cuts. Each resource is rebuilt
/// when its source has changed, and exists only if the frame needs it.
class VolumeResources
{
public:
  /// Updates the voxels. Must be called first, because the choice of the marcher depends on them.
  void UpdateVoxels(const Frame& frame);

  /// Updates everything except the voxels and the pre-integrated table.
  /// @throws std::runtime_error if the device cannot hold a resource
  VolumeFindings Update(const VolumeMarch& march, const MemoryElsewhere& elsewhere);

  /// Makes the pre-integrated table if the march's integration rule needs it.
  void UpdatePreIntegrated(const VolumeMarch& march) { this->materials.UpdatePreIntegrated(march); }

  /// Begins an image of several blocks, which must then be taken in the given order.
  void BeginPicture(
    const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere);

  /// True if memory suffices for a pre-integrated table that is only tried out.
  bool MayTryPreIntegration(const Frame& frame) const;

  VolumeBuilds Builds() const;
  double FieldBuildSeconds() const { return this->fields.BuildSeconds(this->Blocks()); }
  std::size_t Bytes() const; ///< The graphics memory of all resources.
  void Release(vtkWindow* window);

  const MaterialResources& Materials() const { return this->materials; }
  FieldResources& Fields() { return this->fields; }
  const FieldResources& Fields() const { return this->fields; }
  ProcessorVolume& Packets() { return this->packets; }
  const ProcessorVolume& Packets() const { return this->packets; }
  const VolumeDivision& Division() const { return this->division; }
  VolumeBlocks& Blocks() { return this->division.Blocks(); }
  const VolumeBlocks& Blocks() const { return this->division.Blocks(); }
  const LightResources& Light() const { return this->light; }
  const MaskTexture& Mask() const { return this->mask; }
  /// The textures of the volume.
  /// @param block  null for the volume of the processor, or if the shader marches no rays
  VolumeTextures Textures(const RenderSettings& settings, const VolumeBlock* block) const;
  MarchTexture ClippingPlanes() const { return this->clippingPlanes.Texture(); }
  const UnevenBins& SpacingBins() const { return this->spacingBins; }

private:
  void SetValues(const Frame& frame, bool areNew);
  void UpdateMask(const VolumeMarch& march);
  void UpdateCuts(const VolumeMarch& march);
  void UpdateSpacing(const VolumeMarch& march);
  MemoryElsewhere BesideBlocks(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesBesideBlocks() const;

  Fingerprint voxels; ///< The voxels of the last update; empty before the first.
  int voxelsBuild = 0;
  SplineVolume spline;     ///< Empty without cubic interpolation.
  VoxelValues allValues;   ///< The voxels in the format in which all their values matter.
  Fingerprint valueInputs; ///< The inputs of the values that matter now.

  VolumeDivision division;
  MaterialResources materials;
  FieldResources fields;
  ProcessorVolume packets;
  LightResources light;
  MaskTexture mask;
  FloatTable clippingPlanes;
  FloatTable spacing;     ///< The bins as a table; empty unless the grid is rectilinear.
  UnevenBins spacingBins; ///< The bins that find a voxel in a rectilinear grid.
};

}

#endif
