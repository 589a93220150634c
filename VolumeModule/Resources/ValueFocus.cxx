#include "Resources/ValueFocus.h"

#include "Core/Look/OpticalTable.h"
#include "Frame/FiniteRange.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

using OptionalRange = std::optional<ValueRange>;

// The number of widths of the values that matter by which a format reaches beyond them on either
// side, so that an edit of a transfer function seldom needs another format.
constexpr double WidthsBeside = 16.0;

OptionalRange Both(const OptionalRange& one, const OptionalRange& other)
{
  return !one || !other
    ? (one ? one : other)
    : ValueRange{ std::min(one->lower, other->lower), std::max(one->upper, other->upper) };
}

std::vector<OptionalRange> ValuesOfFunctions(const Frame& frame)
{
  std::vector<OptionalRange> values(frame.voxels.components.size());
  for (const MaterialFunction& function : frame.material.functions.ofMaterials)
  {
    OptionalRange& ofComponent = values[function.component];
    ofComponent = Both(ofComponent, function.transferFunction.ChangingValues());
  }
  return values;
}

// Where all values look the same, light still shows how the usual ones change.
std::vector<OptionalRange> LitValues(const Frame& frame)
{
  std::vector<OptionalRange> values = ValuesOfFunctions(frame);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!values[i] && frame.settings.shading)
    {
      values[i] = UsualRangeOf(frame.voxels.components[i]);
    }
  }
  return values;
}

}

std::vector<OptionalRange> ValuesThatMatter(const Frame& frame)
{
  const std::size_t count = frame.voxels.components.size();
  const MaterialRequest& material = frame.material;
  if (frame.settings.functionOf != FunctionOf::Value || frame.settings.blend == Blend::Additive)
  {
    return std::vector<OptionalRange>(count);
  }
  switch (frame.settings.blend)
  {
    case Blend::AverageIntensity:
      return std::vector<OptionalRange>(
        count, ValueRange{ material.averagedRange[0], material.averagedRange[1] });
    case Blend::Isosurface:
      return std::vector<OptionalRange>(
        count, ValueRange{ material.isovalues.front(), material.isovalues.back() });
    default:
      return LitValues(frame);
  }
}

Fingerprint ValueInputs(const Frame& frame)
{
  return Fingerprint(frame.material.functions.inputs, frame.settings.blend, frame.settings.shading,
    frame.material.averagedRange, frame.material.isovalues);
}

std::vector<ValueRange> OpaqueValuesOf(const Frame& frame, const ScalarTexels& texels)
{
  return OpaqueValues(
    frame.material.functions.first, { texels.smallestScalar, texels.largestScalar });
}

void CheckReach(const ScalarTexels& texels, const OptionalRange& thatMatter)
{
  const bool reach = thatMatter &&
    ((texels.smallestScalar <= -LargestNumber && thatMatter->lower <= -LargestNumber) ||
      (texels.largestScalar >= LargestNumber && thatMatter->upper >= LargestNumber));
  if (reach)
  {
    std::ostringstream message;
    message << "Cannot draw scalars farther from 0 than " << LargestNumber
            << " that the transfer function tells apart: expected smaller ones; multiply them, and "
               "the nodes of the function, by a small number";
    throw std::runtime_error(message.str());
  }
}

ValueRange NearValues(const ValueRange& all, const OptionalRange& thatMatter)
{
  const ValueRange matter = thatMatter ? thatMatter->And(all) : ValueRange{ 1.0, 0.0 };
  if (matter.IsEmpty())
  {
    return all;
  }
  const double besideMatter = WidthsBeside * WidthOf(matter);
  return ValueRange{ matter.lower - besideMatter, matter.upper + besideMatter }.And(all);
}

ScalarTexels Focused(
  const ScalarTexels& all, const ScalarTexels& present, const OptionalRange& thatMatter)
{
  const ValueRange matter = thatMatter ? thatMatter->And(all.resolved) : ValueRange{ 1.0, 0.0 };
  if (all.normalized || matter.IsEmpty() || !ReachFarBeyond(all.resolved, matter))
  {
    return all;
  }
  if (present.resolved.Contains(matter) && !ReachFarBeyond(present.resolved, matter))
  {
    return present;
  }
  ScalarTexels focused = all;
  focused.resolved = NearValues(all.resolved, matter);
  focused.mapping = FloatMapping(focused.resolved.lower, focused.resolved.upper);
  return focused;
}

bool MergesValues(const Frame& frame, const std::vector<ScalarTexels>& texels)
{
  constexpr double MostWidths = 65536.0; // floats still tell 256 values of a width apart
  if (!IsProjection(frame.settings.blend) || frame.settings.functionOf != FunctionOf::Value)
  {
    return false;
  }
  const std::vector<OptionalRange> functions = ValuesOfFunctions(frame);
  for (std::size_t i = 0; i < functions.size(); ++i)
  {
    const ValueRange& all = texels[i].resolved;
    const ValueRange matter = functions[i] ? functions[i]->And(all) : ValueRange{ 1.0, 0.0 };
    if (!texels[i].normalized && !matter.IsEmpty() && all.Width() > MostWidths * WidthOf(matter))
    {
      return true;
    }
  }
  return false;
}

}
