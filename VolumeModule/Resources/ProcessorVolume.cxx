#include "Resources/ProcessorVolume.h"

#include "Readers/MappedScalars.h"
#include "Readers/VoxelLayout.h"
#include "Resources/VolumeGaps.h"

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
  if (const auto summary = SummaryOf(array))
  {
    return summary->areFinite;
  }
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

// True if packets can read a component in place.
bool IsReadInPlace(const VoxelComponent& component)
{
  return VoxelTypeOf(component.array->GetDataType()) &&
    component.array->GetNumberOfComponents() == 1;
}

ComponentCopy CopyForPackets(const VoxelComponent& component)
{
  return VoxelTypeOf(component.array->GetDataType()) ? CopyAsItIs(component)
                                                     : CopyAsFloats(component);
}

}

void ProcessorVolume::SetVoxels(const VoxelComponents& newComponents)
{
  this->Release();
  this->components = newComponents;
  this->voxelsAreFinite.reset();
}

// A copy already knows whether its values are finite.
bool ProcessorVolume::AreFinite()
{
  if (!this->voxelsAreFinite)
  {
    bool areFinite = true;
    this->copies.clear();
    for (const VoxelComponent& component : this->components)
    {
      this->copies.push_back(
        IsReadInPlace(component) ? ComponentCopy() : CopyForPackets(component));
      const ComponentCopy& copy = this->copies.back();
      areFinite =
        areFinite && (copy.array ? copy.allFinite : varimarch::AreFinite(component.array));
    }
    this->voxelsAreFinite = areFinite;
  }
  return *this->voxelsAreFinite;
}

void ProcessorVolume::Update(const VolumeMarch& march, const VoxelValues& values)
{
  this->UpdateVoxels(march.plan.marcher);
  this->UpdateGaps(march, values);
}

void ProcessorVolume::UpdateVoxels(Marcher marcher)
{
  if (marcher == Marcher::Device)
  {
    this->copies.clear();
    return;
  }
  const bool areFinite = this->voxelsAreFinite.value_or(true);
  this->copies.resize(this->components.size());
  for (std::size_t i = 0; i < this->components.size(); ++i)
  {
    ComponentCopy& copy = this->copies[i];
    if (!copy.array && !(areFinite && IsReadInPlace(this->components[i])))
    {
      copy = CopyForPackets(this->components[i]);
    }
  }
}

void ProcessorVolume::UpdateGaps(const VolumeMarch& march, const VoxelValues& values)
{
  const Blanking& blanking = march.frame.voxels.blanking;
  const bool hasAny = blanking.Any() || !this->voxelsAreFinite.value_or(true);
  if (march.plan.marcher == Marcher::Device || !hasAny)
  {
    this->gaps = GapField();
    this->gapsOf.reset();
  }
  else if (!(this->gapsOf == blanking))
  {
    this->gaps = GapFieldOf(
      { values.components, values.dimensions, { glm::ivec3(0), values.dimensions } }, blanking);
    this->gapsOf = blanking;
  }
}

vtkDataArray* ProcessorVolume::Voxels(std::size_t component) const
{
  const ComponentCopy& copy = this->copies[component];
  return copy.array ? copy.array.Get() : this->components[component].array;
}

void ProcessorVolume::Release()
{
  this->copies.clear();
  this->gaps = GapField();
  this->gapsOf.reset();
}

}
