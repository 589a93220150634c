// What packets of rays read of a volume beside its tables and its field.

#include "Resources/VolumeResources.h"

#include "vtkDataArray.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace varimarch
{

namespace
{

bool AreFinite(vtkDataArray* array)
{
  const float* const voxels = static_cast<const float*>(array->GetVoidPointer(0));
  std::atomic<bool> finite = true;
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, array->GetNumberOfValues(), 1 << 16),
    [&](const tbb::blocked_range<vtkIdType>& part)
    {
      const bool isFinite = std::all_of(voxels + part.begin(), voxels + part.end(),
        [](float voxel) { return std::isfinite(voxel); });
      finite = finite && isFinite;
    });
  return finite;
}

// Where its owner keeps it.
bool IsRead(const VoxelComponent& component)
{
  return PacketVoxelTypeOf(component.array) && component.array->GetNumberOfComponents() == 1;
}

ComponentCopy CopyForPackets(const VoxelComponent& component)
{
  return PacketVoxelTypeOf(component.array) ? CopyAsItIs(component) : CopyAsFloats(component);
}

}

std::optional<VoxelType> PacketVoxelTypeOf(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return VoxelType::Int8;
    case VTK_UNSIGNED_CHAR:
      return VoxelType::UInt8;
    case VTK_SHORT:
      return VoxelType::Int16;
    case VTK_UNSIGNED_SHORT:
      return VoxelType::UInt16;
    case VTK_FLOAT:
      return VoxelType::Float32;
  }
  return std::nullopt;
}

// Of what is copied the copy tells it.
bool VolumeResources::AreVoxelsFinite()
{
  if (!this->voxelsAreFinite)
  {
    bool areFinite = true;
    this->packetVoxels.clear();
    for (const VoxelComponent& component : this->MarchedComponents())
    {
      this->packetVoxels.push_back(IsRead(component) ? ComponentCopy() : CopyForPackets(component));
      const ComponentCopy& copy = this->packetVoxels.back();
      areFinite = areFinite && (copy.array ? copy.allFinite : AreFinite(component.array));
    }
    this->voxelsAreFinite = areFinite;
  }
  return *this->voxelsAreFinite;
}

void VolumeResources::UpdatePacketVoxels(const Frame& frame)
{
  if (frame.marcher == Marcher::Device)
  {
    this->packetVoxels.clear();
    return;
  }
  const VoxelComponents components = this->MarchedComponents();
  const bool isFinite = this->voxelsAreFinite.value_or(true);
  this->packetVoxels.resize(components.size());
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    ComponentCopy& copy = this->packetVoxels[i];
    if (!copy.array && !(isFinite && IsRead(components[i])))
    {
      copy = CopyForPackets(components[i]);
    }
  }
}

void VolumeResources::UpdatePacketGaps(Frame& frame)
{
  const bool hasAny = frame.blanking.Any() || !this->voxelsAreFinite.value_or(true);
  if (frame.marcher == Marcher::Device || !hasAny)
  {
    this->packetGaps = GapField();
    this->packetGapsOfVolume = 0;
    return;
  }
  if (this->packetGapsOfVolume != this->builds.volumeTexture ||
    !(this->packetGapsBlanking == frame.blanking))
  {
    const VoxelValues& values = this->blocks.Values();
    this->packetGaps =
      GapFieldOf({ values.components, values.dimensions, { glm::ivec3(0), values.dimensions } },
        frame.blanking);
    this->packetGapsBlanking = frame.blanking;
    this->packetGapsOfVolume = this->builds.volumeTexture;
  }
  frame.settings.gaps = true;
}

vtkDataArray* VolumeResources::PacketVoxels(std::size_t component) const
{
  const ComponentCopy& copy = this->packetVoxels[component];
  return copy.array ? copy.array.Get() : this->MarchedComponents()[component].array;
}

}
