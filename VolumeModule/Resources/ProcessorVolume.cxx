#include "Resources/ProcessorVolume.h"

#include "Readers/Paging/MappedMemory.h"
#include "Readers/VoxelLayout.h"
#include "Resources/VolumeGaps.h"

#include "vtkDataArray.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

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

// True if floats can represent the scalars directly.
bool IsPlain(const ScalarTexels& texels, vtkDataArray* array)
{
  constexpr double MostWhole = 1 << 24; // floats represent all integers up to this one
  const double farthest = std::max(-texels.smallestScalar, texels.largestScalar);
  if (texels.normalized)
  {
    constexpr double MostWidths = 1 << 12; // floats between these tell parts of their range apart
    const double width = std::max(texels.largestScalar - texels.smallestScalar, 1.0);
    return farthest <= MostWidths * width &&
      (farthest <= MostWhole || VoxelTypeOf(array->GetDataType()));
  }
  constexpr double Large = 1e15;
  const bool isConstant = texels.smallestScalar == texels.largestScalar && farthest <= MostWhole;
  return (texels.mapping.offset == 0.0 || isConstant) && farthest <= Large &&
    texels.mapping.scale >= 1.0 / Large;
}

// A copy in which each voxel that is alone along an axis is there twice.
vtkSmartPointer<vtkDataArray> Doubled(vtkDataArray* voxels, const glm::ivec3& dimensions)
{
  const glm::ivec3 count = glm::max(dimensions, 2);
  vtkSmartPointer<vtkDataArray> doubled;
  doubled.TakeReference(vtkDataArray::CreateDataArray(voxels->GetDataType()));
  doubled->SetNumberOfTuples(vtkIdType(count.x) * count.y * count.z);
  const std::size_t bytes = voxels->GetDataTypeSize();
  const std::size_t rowBytes = bytes * std::size_t(dimensions.x);
  const auto* const source = static_cast<const char*>(voxels->GetVoidPointer(0));
  auto* target = static_cast<char*>(doubled->GetVoidPointer(0));
  for (int z = 0; z < count.z; ++z)
  {
    for (int y = 0; y < count.y; ++y)
    {
      const vtkIdType row =
        vtkIdType(std::min(z, dimensions.z - 1)) * dimensions.y + std::min(y, dimensions.y - 1);
      for (int copies = 0; copies < count.x / dimensions.x; ++copies)
      {
        target = std::copy_n(source + row * rowBytes, rowBytes, target);
      }
    }
  }
  return doubled;
}

}

std::vector<TexelMapping> MappingsForPackets(
  const std::vector<ScalarTexels>& texels, const VoxelComponents& components)
{
  std::vector<TexelMapping> mappings;
  bool arePlain = true;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    mappings.push_back(texels[i].mapping);
    arePlain = arePlain && IsPlain(texels[i], components[i].array);
  }
  return arePlain ? std::vector<TexelMapping>(components.size()) : mappings;
}

void ProcessorVolume::SetVoxels(
  const VoxelComponents& newComponents, const glm::ivec3& newDimensions)
{
  this->Release();
  this->components = newComponents;
  this->dimensions = newDimensions;
  this->mappings.assign(newComponents.size(), TexelMapping());
  this->voxelsAreFinite.reset();
}

void ProcessorVolume::SetTexels(const std::vector<ScalarTexels>& texels)
{
  std::vector<TexelMapping> newMappings = MappingsForPackets(texels, this->components);
  if (!(newMappings == this->mappings))
  {
    this->Release();
    this->voxelsAreFinite.reset();
    this->mappings = std::move(newMappings);
  }
}

bool ProcessorVolume::IsReadInPlace(std::size_t i) const
{
  vtkDataArray* const array = this->components[i].array;
  return VoxelTypeOf(array->GetDataType()) && array->GetNumberOfComponents() == 1 &&
    this->mappings[i] == TexelMapping() && this->VoxelCount() == this->dimensions;
}

ComponentCopy ProcessorVolume::CopyOf(std::size_t i) const
{
  const VoxelComponent& component = this->components[i];
  ComponentCopy copy = !(this->mappings[i] == TexelMapping())
    ? CopyAsTexels(component, this->mappings[i])
    : VoxelTypeOf(component.array->GetDataType()) ? CopyAsItIs(component)
                                                  : CopyAsFloats(component);
  if (this->VoxelCount() != this->dimensions)
  {
    copy.array = Doubled(copy.array, this->dimensions);
  }
  return copy;
}

// A copy already knows whether its values are finite.
bool ProcessorVolume::AreFinite()
{
  if (!this->voxelsAreFinite)
  {
    bool areFinite = true;
    this->copies.clear();
    for (std::size_t i = 0; i < this->components.size(); ++i)
    {
      this->copies.push_back(this->IsReadInPlace(i) ? ComponentCopy() : this->CopyOf(i));
      const ComponentCopy& copy = this->copies.back();
      areFinite = areFinite &&
        (copy.array ? copy.allFinite : varimarch::AreFinite(this->components[i].array));
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
    if (!copy.array && !(areFinite && this->IsReadInPlace(i)))
    {
      copy = this->CopyOf(i);
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
