#include "Resources/ScalarTexels.h"

#include "Frame/FiniteRange.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr double Largest8 = 255.0;
constexpr double Largest16 = 65535.0;

// Spreads integers over 8 or 16 bits by an integer factor, so that each voxel's texel is exact and
// the filter interpolates with all bits. A texel of 8 bits has the same value in 16, 257 times as
// large.
TexelMapping NormalizedMapping(double smallest, double largest)
{
  const double difference = std::max(largest - smallest, 1.0);
  const double steps = difference <= Largest8 ? Largest8 : Largest16;
  return { steps / std::floor(steps / difference), smallest };
}

// A table tells apart what is far narrower than the range of the scalars, and no narrower than
// SmallestDifference.
void CheckDifference(const ScalarTexels& texels)
{
  constexpr double Smallest = 1e10 * SmallestDifference;
  const double difference = texels.largestScalar - texels.smallestScalar;
  if (0.0 < difference && difference < Smallest)
  {
    std::ostringstream message;
    message << "Cannot draw scalars that differ by at most " << difference << ": expected "
            << Smallest << " or more; multiply them by a large number";
    throw std::runtime_error(message.str());
  }
}

}

// Scales by a power of two, which is exact. Numbers are shifted only if their range is small
// compared with its distance from zero, as for doubles around 1e7 that differ by 1, or if all are
// the same, for floats need not represent that number.
TexelMapping FloatMapping(double smallest, double largest)
{
  const double range = largest - smallest;
  const double farthest = std::max(std::abs(smallest), std::abs(largest));
  const bool farFromZero = farthest > 2.0 * range;
  const double extent = farFromZero && range > 0.0 ? range : farthest;
  const double scale = extent > 0.0 ? std::exp2(std::ceil(std::log2(extent))) : 1.0;
  return { scale, farFromZero ? smallest : 0.0 };
}

double TexelMapping::LimitedTexelOf(double scalar) const
{
  constexpr double most = 1e30;
  return std::clamp(this->TexelOf(scalar), -most, most);
}

std::vector<ScalarTexels> ScalarTexelsOf(const VoxelComponents& components)
{
  std::vector<ScalarTexels> all;
  bool allNormalized = true;
  bool allIntegers = true;
  for (const VoxelComponent& component : components)
  {
    const ValueRange finite = FiniteRangeOf(component);
    const bool anyFinite = !finite.IsEmpty();
    const int type = component.array->GetDataType();
    ScalarTexels texels;
    texels.smallestScalar = anyFinite ? Limited(finite.lower) : 0.0;
    texels.largestScalar = anyFinite ? Limited(finite.upper) : 0.0;
    CheckDifference(texels);
    texels.smallestValue = texels.smallestScalar;
    texels.largestValue = texels.largestScalar;
    texels.gray = { texels.smallestScalar, texels.largestScalar };
    texels.resolved = texels.gray;
    allIntegers = allIntegers && type != VTK_FLOAT && type != VTK_DOUBLE;
    allNormalized =
      allNormalized && allIntegers && texels.largestScalar - texels.smallestScalar <= Largest16;
    all.push_back(texels);
  }
  for (ScalarTexels& texels : all)
  {
    texels.finite = allIntegers;
    texels.normalized = allNormalized;
    texels.fits8Bits = allNormalized && texels.largestScalar - texels.smallestScalar <= Largest8;
    texels.mapping = allNormalized ? NormalizedMapping(texels.smallestScalar, texels.largestScalar)
                                   : FloatMapping(texels.smallestScalar, texels.largestScalar);
  }
  return all;
}

TexelFormat TexelFormatOf(const std::vector<ScalarTexels>& texels, bool filters8Bits)
{
  const bool fit8Bits = std::all_of(texels.begin(), texels.end(),
    [](const ScalarTexels& ofComponent) { return ofComponent.fits8Bits; });
  if (fit8Bits && filters8Bits)
  {
    return TexelFormat::Integers8;
  }
  return texels.front().normalized ? TexelFormat::Integers16 : TexelFormat::Floats;
}

std::size_t BytesOf(TexelFormat format)
{
  switch (format)
  {
    case TexelFormat::Integers8:
      return 1;
    case TexelFormat::Integers16:
      return 2;
    default:
      return sizeof(float);
  }
}

}
