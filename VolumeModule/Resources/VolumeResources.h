#ifndef Varimarch_Resources_VolumeResources_h
#define Varimarch_Resources_VolumeResources_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/UnevenAxis.h"
#include "Frame/MarchPlan.h"
#include "Resources/FieldResources.h"
#include "Resources/FloatTable.h"
#include "Resources/LightResources.h"
#include "Resources/MaskTexture.h"
#include "Resources/MaterialResources.h"
#include "Resources/ProcessorVolume.h"
#include "Resources/VolumeBlocks.h"
#include "Resources/VolumeTexture.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class vtkDataArray;

namespace varimarch
{

/// The graphics memory that an image takes besides the blocks of its volume [bytes].
struct MemoryElsewhere
{
  std::size_t fixedBytes = 0;        ///< The memory of everything else.
  std::size_t accumulationBytes = 0; ///< The memory of RayAccumulation at present.
};

/// A volume in as many blocks as the graphics memory requires, and the boxes around its visible
/// parts. A volume that the processor marches is one block without textures.
class VolumeDivision
{
public:
  /// Divides the volume. A single block is uploaded to the device at once. A volume that overlaps
  /// others is not divided: the device does not get it if it is too large.
  /// @return true if the volume has gaps or, if it is in several blocks, may have gaps
  /// @throws std::runtime_error if the memory is too small, or a feature is not available in blocks
  bool Update(
    const VolumeMarch& march, const FieldResources& fields, const MemoryElsewhere& elsewhere);

  /// Begins an image of several blocks, which must then be taken in the given order.
  void BeginPicture(
    const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere);

  /// The blocks that may have visible parts in view, front to back.
  std::vector<int> InView(const VolumeMarch& march) const;

  /// True if the device cannot hold a volume that overlaps others, which has no blocks.
  bool IsTooLarge() const { return this->isTooLarge; }

  VolumeBlocks& Blocks() { return this->blocks; }
  const VolumeBlocks& Blocks() const { return this->blocks; }
  /// The box around the part that is visible after cuts and by the field [grid space].
  const Box& VisibleBox() const { return this->visibleBox; }
  const Box& VisibleBoxOf(int block) const { return this->visibleBoxes[block]; }
  void Release(vtkWindow* window);

private:
  void UpdateVisibleBoxes(const VolumeMarch& march, const FieldResources& fields);
  bool FitsMemory(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  bool MustBeDivided(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  BlockLimits LimitsOf(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesForBlocks(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const;

  VolumeBlocks blocks;
  bool isTooLarge = false;
  Box visibleBox = {};
  std::vector<Box> visibleBoxes; ///< The box around the visible part of each block.
  int visibleOfField = -1;       ///< The build number of the field behind the boxes; 0: no field.
  Box visibleOfBox = {};         ///< The box of the cuts behind the boxes.
};

/// The coefficients of the tricubic splines through the voxels of a volume (SplineCoefficients.h).
/// They replace the voxels on the graphics device and in everything computed from values.
class SplineVolume
{
public:
  /// Makes an empty spline.
  SplineVolume() = default;

  /// @throws std::runtime_error if a voxel is not finite, because then no coefficient would be
  SplineVolume(const VoxelComponents& components, glm::ivec3 dimensions);

  /// The coefficients, in arrays that this object owns.
  VoxelComponents Components() const;

  /// The texel format of the coefficients. Its range of scalars is that of the voxels.
  std::vector<ScalarTexels> Texels(const VoxelComponents& voxels) const;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> coefficients; ///< The coefficients of each component.
};

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
