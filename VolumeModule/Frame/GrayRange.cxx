#include "Frame/GrayRange.h"

#include "vtkDataArray.h"

namespace varimarch
{

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
