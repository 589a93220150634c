// The tables that materials are looked up in, and the masks that tell which: resources and
// uniforms.

#include "Core/ShaderRecipe.h"
#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

namespace varimarch
{

std::vector<OpticalTable> RayMarcher::BuildTables(const Frame& frame)
{
  const ScalarTexels& first = this->blocks.Texels();
  this->twoValues.Release(frame.window);
  if (frame.settings.functionOf != FunctionOf::Value)
  {
    TwoValueTable table = TwoValueTableOf(frame.property);
    const double unitDistanceMm = frame.property->GetScalarOpacityUnitDistance();
    this->materialTables = { { 0, TransferFunction({}, {}, unitDistanceMm), true } };
    OpticalTable bound =
      UpperBound(table, { first.smallestScalar, first.largestScalar }, unitDistanceMm);
    this->twoValuesSize = table.size;
    this->twoValues.Set(frame.window, std::move(table.entries));
    return { std::move(bound) };
  }
  constexpr std::size_t MostEntries = 65536; // of all tables together,
  constexpr std::size_t FewestEntries = 256; // but not less than these of each
  this->materialTables = MaterialTablesOf(frame.property, frame.settings);
  const std::size_t entries = std::max(MostEntries / this->materialTables.size(), FewestEntries);
  std::vector<OpticalTable> tables;
  for (const MaterialTable& table : this->materialTables)
  {
    const ScalarTexels& texels = this->blocks.TexelsOfChannels()[table.channel];
    tables.push_back(BuildOpticalTable(
      table.transferFunction, texels.smallestValue, texels.largestValue, entries));
  }
  return tables;
}

void RayMarcher::UpdateMask(const Frame& frame)
{
  if (frame.settings.mask == Mask::None)
  {
    this->mask.Release(frame.window);
  }
  else
  {
    this->mask.Update(frame.window, frame.mask);
  }
}

void RayMarcher::SetMaskUniforms(const Frame& frame)
{
  const glm::dvec3 size(this->mask.Size());
  this->mask.Texture()->Activate();
  this->program.Set("maskTexture", this->mask.Texture());
  this->program.Set("maskVoxelCount", size);
  this->program.Set("maskVoxelsPerVoxel", size / glm::dvec3(frame.geometry.dimensions));
  if (frame.settings.mask == Mask::Labels)
  {
    this->program.Set("labelPart", frame.labelPart);
    this->program.Set("labelUnitDistanceMm", frame.property->GetScalarOpacityUnitDistance());
  }
}

void RayMarcher::SetTwoValueUniforms(const Frame& frame)
{
  const auto placeOf = [](const ScalarTexels& texels)
  {
    const double range = texels.largestScalar - texels.smallestScalar;
    const double perValue = range > 0.0 ? 1.0 / range : 0.0;
    return glm::dvec2(
      texels.mapping.scale * perValue, (texels.mapping.offset - texels.smallestScalar) * perValue);
  };
  const std::vector<ScalarTexels>& texels = this->blocks.TexelsOfChannels();
  this->twoValues.Texture()->Activate();
  this->program.Set("twoValueTable", this->twoValues.Texture());
  this->program.Set("twoValueTableSize", glm::dvec2(this->twoValuesSize));
  this->program.Set("tableUnitDistanceMm", frame.property->GetScalarOpacityUnitDistance());
  this->program.Set("placeFromScalar", placeOf(texels.front()));
  if (frame.settings.functionOf == FunctionOf::TwoValues)
  {
    this->program.Set("placeFromSecond", placeOf(texels.back()));
    return;
  }
  this->program.Set("spacingFactors", frame.geometry.gradientFactors);
  this->program.Set(
    "placePerGradient", texels.front().mapping.scale / LargestGradient(texels.front()));
}

}
