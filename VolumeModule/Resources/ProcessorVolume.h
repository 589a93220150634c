#ifndef Varimarch_Resources_ProcessorVolume_h
#define Varimarch_Resources_ProcessorVolume_h

#include "Core/Fields/GapField.h"
#include "Core/Packets/PacketScene.h"
#include "Frame/MarchPlan.h"
#include "Resources/ComponentCopy.h"
#include "Resources/VolumeTexture.h"

#include <glm/common.hpp>

#include <cstddef>
#include <optional>
#include <vector>

class vtkDataArray;

namespace varimarch
{

/// The mappings from the numbers that packets read to the scalars of each component. Packets read
/// scalars themselves where floats can represent those of all components. Others, which are too
/// large, too small or too far from zero, are shifted and scaled as for shaders.
std::vector<TexelMapping> MappingsForPackets(
  const std::vector<ScalarTexels>& texels, const VoxelComponents& components);

/// The voxels of a volume in the form that packets of rays read, and the gaps between them. Voxels
/// are read in place if possible, otherwise copied. Copies and gaps are kept only while the
/// processor marches.
class ProcessorVolume
{
public:
  /// Replaces the voxels. They are not read before they are needed.
  void SetVoxels(const VoxelComponents& newComponents, const glm::ivec3& newDimensions);

  /// Replaces the formats of the components, which follow the looks.
  void SetTexels(const std::vector<ScalarTexels>& texels);

  /// True if all voxels are finite. Reads them once. Requires types other than integers of 16 bits.
  bool AreFinite();

  /// Makes the copies and gaps that the march needs, and releases others.
  void Update(const VolumeMarch& march, const VoxelValues& values);

  /// A component in which non-finite values are 0. Requires an Update() for the processor.
  vtkDataArray* Voxels(std::size_t component = 0) const;

  /// The mapping from the numbers of a component to its scalars.
  const std::vector<TexelMapping>& Mappings() const { return this->mappings; }

  /// The number of voxels: at least two along each axis. A lone voxel is there twice.
  glm::ivec3 VoxelCount() const { return glm::max(this->dimensions, 2); }

  /// The texels of GapField, which are null if there are no gaps, and their number.
  const void* GapTexels() const { return this->HasGaps() ? this->gaps.texels.data() : nullptr; }
  glm::ivec3 GapCells() const { return this->gaps.count; }
  bool HasGaps() const { return !this->gaps.texels.empty(); }

  void Release();

private:
  bool IsReadInPlace(std::size_t component) const;
  ComponentCopy CopyOf(std::size_t component) const;
  void UpdateVoxels(Marcher marcher);
  void UpdateGaps(const VolumeMarch& march, const VoxelValues& values);

  VoxelComponents components;
  glm::ivec3 dimensions = glm::ivec3(0);
  std::vector<TexelMapping> mappings;
  std::vector<ComponentCopy> copies;   ///< The copies of all components, or none.
  std::optional<bool> voxelsAreFinite; ///< The result of AreFinite(), once known.
  GapField gaps;
  std::optional<Blanking>
    gapsOf; ///< The flags that the gaps were made from; empty if there are no gaps.
};

}

#endif
