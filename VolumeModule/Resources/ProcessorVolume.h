#ifndef Varimarch_Resources_ProcessorVolume_h
#define Varimarch_Resources_ProcessorVolume_h

#include "Core/Fields/GapField.h"
#include "Core/Packets/PacketScene.h"
#include "Frame/MarchPlan.h"
#include "Resources/ComponentCopy.h"
#include "Resources/VolumeTexture.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkDataArray;

namespace varimarch
{

/// The type by which packets read the numbers of an array; nothing if they cannot read them.
std::optional<VoxelType> PacketVoxelTypeOf(vtkDataArray* array);

/// The voxels of a volume as packets of rays read them: where their owner keeps them, or copies of
/// those that packets cannot read; and the gaps between them. All of it is in memory, and only
/// while the processor marches.
class ProcessorVolume
{
public:
  /// Takes other voxels. Nothing is read before it is needed.
  void SetVoxels(const VoxelComponents& newComponents);

  /// True if all voxels are finite. Reads them once; their types are those of real numbers.
  bool AreFinite();

  /// Makes what the march needs, or lets go of it.
  void Update(const VolumeMarch& march, const VoxelValues& values);

  /// A component without numbers that are not finite. Only after Update for the processor.
  vtkDataArray* Voxels(std::size_t component = 0) const;

  /// The gaps; empty if there are none.
  const GapField& Gaps() const { return this->gaps; }
  bool HasGaps() const { return !this->gaps.texels.empty(); }

  void Release();

private:
  void UpdateVoxels(Marcher marcher);
  void UpdateGaps(const VolumeMarch& march, const VoxelValues& values);

  VoxelComponents components;
  std::vector<ComponentCopy> copies;   ///< One for each component, or none at all.
  std::optional<bool> voxelsAreFinite; ///< Nothing until somebody has asked.
  GapField gaps;
  std::optional<Blanking>
    gapsOf; ///< The flags that the gaps were made with; nothing: none are made.
};

}

#endif
