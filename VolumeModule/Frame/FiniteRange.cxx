#include "Frame/FiniteRange.h"

#include "Readers/Paging/MappedMemory.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace varimarch
{

namespace
{

// The extremes of some scalars; lowest > highest if there are none.
template <class Scalar>
struct Extremes
{
  Scalar lowest = std::numeric_limits<Scalar>::max();
  Scalar highest = std::numeric_limits<Scalar>::lowest();

  void Add(Scalar scalar)
  {
    this->lowest = std::min(this->lowest, scalar);
    this->highest = std::max(this->highest, scalar);
  }

  Extremes And(const Extremes& other) const
  {
    return { std::min(this->lowest, other.lowest), std::max(this->highest, other.highest) };
  }
};

template <class Scalar>
bool IsFinite(Scalar scalar)
{
  if constexpr (std::is_floating_point<Scalar>::value)
  {
    return std::isfinite(scalar);
  }
  return true;
}

// Adjacent scalars, several at a time: the constant number lets the compiler use vectors. A
// comparison with NaN is false, so that it never becomes an extreme; infinity does.
template <class Scalar>
Extremes<Scalar> ExtremesOf(const Scalar* scalars, std::ptrdiff_t count)
{
  constexpr std::ptrdiff_t AtOnce = 64;
  std::array<Scalar, AtOnce> lowest;
  std::array<Scalar, AtOnce> highest;
  lowest.fill(Extremes<Scalar>().lowest);
  highest.fill(Extremes<Scalar>().highest);
  std::ptrdiff_t i = 0;
  for (; i + AtOnce <= count; i += AtOnce)
  {
    for (std::ptrdiff_t lane = 0; lane < AtOnce; ++lane)
    {
      lowest[lane] = std::min(lowest[lane], scalars[i + lane]);
      highest[lane] = std::max(highest[lane], scalars[i + lane]);
    }
  }
  Extremes<Scalar> extremes;
  for (std::ptrdiff_t lane = 0; lane < AtOnce; ++lane)
  {
    extremes = extremes.And({ lowest[lane], highest[lane] });
  }
  for (; i < count; ++i)
  {
    extremes.Add(scalars[i]);
  }
  return extremes;
}

template <class Scalar>
Extremes<Scalar> FiniteExtremesOf(
  const Scalar* scalars, std::ptrdiff_t stride, std::ptrdiff_t count)
{
  if (stride == 1)
  {
    const Extremes<Scalar> all = ExtremesOf(scalars, count);
    if (IsFinite(all.lowest) && IsFinite(all.highest))
    {
      return all;
    }
  }
  Extremes<Scalar> extremes;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    if (IsFinite(scalars[i * stride]))
    {
      extremes.Add(scalars[i * stride]);
    }
  }
  return extremes;
}

template <class Scalar>
ValueRange FiniteRangeOf(const Scalar* scalars, std::ptrdiff_t stride, std::ptrdiff_t count)
{
  constexpr std::ptrdiff_t AtOnce = 1 << 16;
  using Part = tbb::blocked_range<std::ptrdiff_t>;
  const Extremes<Scalar> extremes = tbb::parallel_reduce(
    Part(0, count, AtOnce), Extremes<Scalar>(),
    [&](const Part& part, const Extremes<Scalar>& before)
    {
      return before.And(
        FiniteExtremesOf(scalars + part.begin() * stride, stride, part.end() - part.begin()));
    },
    [](const Extremes<Scalar>& one, const Extremes<Scalar>& other) { return one.And(other); });
  return { double(extremes.lowest), double(extremes.highest) };
}

}

ValueRange FiniteRangeOf(const VoxelComponent& component)
{
  vtkDataArray* const array = component.array;
  if (const auto summary = SummaryOf(array))
  {
    return { summary->smallest, summary->largest };
  }
  const std::ptrdiff_t stride = array->GetNumberOfComponents();
  const std::ptrdiff_t count = array->GetNumberOfTuples();
  void* const scalars = array->GetVoidPointer(component.index);
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return FiniteRangeOf(static_cast<const VTK_TT*>(scalars), stride, count));
  }
  return { 1.0, 0.0 };
}

ValueRange UsualRangeOf(const VoxelComponent& component)
{
  constexpr vtkIdType MostSamples = 4096;
  constexpr vtkIdType Stride = 15485863; // a prime, so that samples do not lie in one plane
  const vtkIdType count = component.array->GetNumberOfTuples();
  std::vector<double> samples;
  for (vtkIdType i = 0; i < std::min(count, MostSamples); ++i)
  {
    const double scalar = component.array->GetComponent(i * Stride % count, component.index);
    if (std::isfinite(scalar))
    {
      samples.push_back(scalar);
    }
  }
  if (samples.empty())
  {
    return { 1.0, 0.0 };
  }
  std::sort(samples.begin(), samples.end());
  const std::size_t twentieth = samples.size() / 20;
  return { samples[twentieth], samples[samples.size() - 1 - twentieth] };
}

namespace
{

// The range of the scalars within a range of values; the latter if there are none.
ValueRange RangeWithin(const VoxelComponent& component, const ValueRange& values)
{
  ValueRange range{ values.upper, values.lower };
  for (vtkIdType i = 0; i < component.array->GetNumberOfTuples(); ++i)
  {
    const double scalar = component.array->GetComponent(i, component.index);
    if (values.lower <= scalar && scalar <= values.upper)
    {
      range = { std::min(range.lower, scalar), std::max(range.upper, scalar) };
    }
  }
  return range.IsEmpty() ? values : range;
}

}

ValueRange GrayRangeOf(const VoxelComponent& component, ValueRange counted)
{
  double finite[2];
  component.array->GetFiniteRange(finite, component.index);
  if (finite[0] > finite[1])
  {
    return { 0.0, 0.0 };
  }
  const ValueRange all{ Limited(finite[0]), Limited(finite[1]) };
  const ValueRange matter = all.And(counted);
  return !matter.IsEmpty() && ReachFarBeyond(all, matter) ? RangeWithin(component, matter) : all;
}

}
