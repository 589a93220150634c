#ifndef Varimarch_Resources_VolumeResources_h
#define Varimarch_Resources_VolumeResources_h

#include "Core/Fields/FieldDirections.h"
#include "Core/Packets/PacketScene.h"
#include "Frame/Frame.h"
#include "Resources/ComponentCopy.h"
#include "Resources/FieldTexture.h"
#include "Resources/FloatBufferTexture.h"
#include "Resources/FloatTable.h"
#include "Resources/MaskTexture.h"
#include "Resources/MaterialTables.h"
#include "Resources/OpticalTableTexture.h"
#include "Resources/PreIntegratedTableTexture.h"
#include "Resources/SplineVolume.h"
#include "Resources/VolumeBlocks.h"

#include "vtkType.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <optional>
#include <vector>

class vtkVolumeProperty;

namespace varimarch
{

/// How often each resource of a volume was made.
struct VolumeBuilds
{
  int volumeTexture = 0; ///< by new scalars
  int brickRanges = 0;
  int field = 0; ///< but not of the same field for rays of other directions
  int opticalTable = 0;

  int Sum() const
  {
    return this->volumeTexture + this->brickRanges + this->field + this->opticalTable;
  }
};

/// What a field was made from; it must be made again when any of it differs.
struct FieldSource
{
  Acceleration acceleration;
  int volumeBuild; ///< of the volume's textures
  int tableBuild;  ///< of the optical table; 0 for a field that does not know it
  double tolerance;
  double sense = 0.0; ///< of extremes: 1 for the largest, -1 for the smallest
  Marcher marcher = Marcher::Device;
  std::vector<double> isovalues = {};
  glm::ivec3 towards = glm::ivec3(0); ///< see FieldDirections

  bool operator==(const FieldSource& other) const
  {
    return this->ShowsSame(other) && this->towards == other.towards;
  }

  /// Whether the same is invisible, whatever the rays.
  bool ShowsSame(const FieldSource& other) const
  {
    return this->isovalues == other.isovalues && this->acceleration == other.acceleration &&
      this->volumeBuild == other.volumeBuild && this->tableBuild == other.tableBuild &&
      this->tolerance == other.tolerance && this->sense == other.sense &&
      this->marcher == other.marcher;
  }
};

/// What the numbers of a field of extremes stand for.
struct ExtremeSteps
{
  double sense; ///< 1 for the largest, -1 for the smallest
  double firstValue;
  double valuePerStep;
};

/// What a picture takes of the graphics memory beside its volume.
struct MemoryElsewhere
{
  std::size_t fixedBytes = 0;
  std::size_t accumulationBytes = 0; ///< of its rays, if the volume was in blocks before
};

/// Of each isosurface its colour and optical depth, and its isovalue.
std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame);

/// How packets of rays read numbers as an array has them; nothing where they cannot.
std::optional<VoxelType> PacketVoxelTypeOf(vtkDataArray* array);

/// All that the march through one volume reads: its voxels, what is known of them, and what they
/// look like. Remakes those, and only those, whose source has changed since the last frame; what a
/// frame does not need is not there.
class VolumeResources
{
public:
  /// So many that a piecewise linear function loses less than a display can show.
  static constexpr int EntriesPerGradientCurve = 4096;

  /// First, for who marches depends on them.
  void UpdateVoxels(const Frame& frame);
  void UpdateCuts(const Frame& frame);
  /// All others. Tells the frame what of them it needs.
  /// @throws std::runtime_error when the device cannot hold one
  void Update(Frame& frame, const MemoryElsewhere& elsewhere);
  /// Of the frame's rule of integration.
  void UpdatePreIntegratedTable(const Frame& frame);
  /// Of a volume in several blocks, those that a picture takes, in this order.
  void BeginPicture(
    const Frame& frame, const std::vector<int>& inView, const MemoryElsewhere& elsewhere);
  void Release(vtkWindow* window);

  const VolumeBuilds& Builds() const { return this->builds; }
  double FieldBuildSeconds() const;
  std::size_t Bytes() const;                       ///< on the graphics device
  std::vector<vtkTextureObject*> Textures() const; ///< but those of blocks

  VolumeBlocks& Blocks() { return this->blocks; }
  const VolumeBlocks& Blocks() const { return this->blocks; }
  AccelerationField& Field() { return this->field; } ///< of bricks
  const AccelerationField& Field() const { return this->field; }
  const OpticalTableTexture& OpticalTables() const { return this->opticalTable; }
  const PreIntegratedTableTexture& PreIntegrated() const { return this->preIntegratedTable; }
  const std::vector<MaterialTable>& MaterialTables() const { return this->materialTables; }
  const FloatTable& TwoValues() const { return this->twoValues; }
  glm::ivec2 TwoValuesSize() const { return this->twoValuesSize; }
  const FloatTable& GradientOpacity() const { return this->gradientOpacity; }
  const FloatBufferTexture& LightTexels() const { return this->lights; }
  const MaskTexture& Mask() const { return this->mask; }
  const FloatBufferTexture& ClippingPlanes() const { return this->clippingPlanes; }
  const FloatBufferTexture& Isosurfaces() const { return this->isosurfaces; }
  const FloatBufferTexture& Spacing() const { return this->spacing; }
  const UnevenBins& SpacingBins() const { return this->spacingBins; }

  /// Voxels, or the coefficients of a spline through them.
  VoxelComponents MarchedComponents() const;
  bool AreVoxelsFinite(); ///< of all components, whose types are those of real numbers
  /// A component as packets of rays read it: where its owner keeps it, or a copy, without what is
  /// not finite.
  vtkDataArray* PacketVoxels(std::size_t component = 0) const;

  /// What packets leave out; nothing where that is nothing.
  const GapField& PacketGaps() const { return this->packetGaps; }

  ExtremeSteps ExtremeStepsOf(Blend blend) const;

  const Box& VisibleBox() const { return this->visibleBox; } ///< what of it is drawn
  const Box& VisibleBoxOf(int block) const { return this->visibleBoxes[block]; }
  /// Blocks in which something visible may be in view, front to back.
  std::vector<int> BlocksInView(const Frame& frame) const;

private:
  void UpdateOpticalTable(const Frame& frame);
  std::vector<OpticalTable> BuildTables(const Frame& frame);
  void UpdateGradientOpacity(const Frame& frame);
  void UpdatePacketVoxels(const Frame& frame);
  void UpdatePacketGaps(Frame& frame);
  void UpdateMask(const Frame& frame);
  void UpdateLights(const Frame& frame);
  void UpdateIsosurfaces(const Frame& frame);
  void UpdateSpacing(const Frame& frame);

  void UpdateField(const Frame& frame);
  void UpdateScalarField(const Frame& frame);
  void UpdateOpticalField(const Frame& frame);
  void UpdateExtremes(const Frame& frame);
  void UpdateIsosurfaceField(const Frame& frame);
  bool BeginsField(const Frame& frame, FieldSource& source);
  void UpdateRanges(const Frame& frame);

  void UpdateBlocks(Frame& frame, const MemoryElsewhere& elsewhere);
  void UpdateVisibleBoxes(const Frame& frame);
  BlockLimits LimitsOf(const Frame& frame, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesForBlocks(const Frame& frame, const MemoryElsewhere& elsewhere) const;
  std::size_t FixedBytes(const Frame& frame, const MemoryElsewhere& elsewhere) const;
  std::size_t BytesBesideBlocks() const;

  SplineVolume spline; ///< only where voxels are interpolated by one
  std::vector<ComponentCopy>
    packetVoxels;      ///< of components that packets do not read, where they march
  GapField packetGaps; ///< where they march too
  VolumeBlocks blocks;
  AccelerationField field;
  OpticalTableTexture opticalTable;
  PreIntegratedTableTexture preIntegratedTable;
  std::vector<MaterialTable> materialTables; ///< what is in the optical table
  FloatTable twoValues;                      ///< a transfer function of two values
  glm::ivec2 twoValuesSize = glm::ivec2(1);
  FloatTable gradientOpacity;
  FloatBufferTexture lights; ///< only for the device, where there are others than head lights
  MaskTexture mask;
  FloatBufferTexture clippingPlanes;
  FloatBufferTexture isosurfaces;
  FloatBufferTexture spacing; ///< only where voxels are at uneven places,
  UnevenBins spacingBins;     ///< made of these
  VolumeBuilds builds;
  Box visibleBox = {};
  std::vector<Box> visibleBoxes; ///< and of each block

  // What each resource was made from.
  VoxelComponents volumeSource; ///< none: there is no volume
  vtkMTimeType volumeTime = 0;
  bool volumeIsCubic = false;
  vtkVolumeProperty* tableSource = nullptr;
  std::vector<double> tableInputs;
  std::vector<double> gradientOpacitySource; ///< empty: there is none
  int preIntegratedOfTable = 0;              ///< the optical table's build that it was made from
  std::optional<FieldSource> fieldSource;    ///< none: there is no field
  FieldDirections fieldDirections;
  std::optional<bool> voxelsAreFinite; ///< none: nobody has asked
  Blanking packetGapsBlanking;         ///< that packetGaps are of,
  int packetGapsOfVolume = 0;          ///< and the volume's build
  int rangesOfVolume = 0;              ///< the volume's build that the field's ranges belong to
  int visibleOfField = -1; ///< the field's build that the visible boxes belong to; 0: to none
  Box visibleOfBox = {};   ///< and the box that cuts left then
};

}

#endif
