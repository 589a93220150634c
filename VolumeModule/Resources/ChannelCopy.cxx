#include "Resources/ChannelCopy.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace varimarch
{

namespace
{

/// @return whether all are finite
template <class Scalar, class Number>
bool CopyNumbers(const Scalar* scalars, int stride, vtkIdType count, Number* numbers)
{
  constexpr vtkIdType AtOnce = 1 << 16;
  std::atomic<bool> allFinite = true;
  tbb::parallel_for(vtkIdType(0), count, AtOnce,
    [&](vtkIdType first)
    {
      for (vtkIdType i = first; i < std::min(first + AtOnce, count); ++i)
      {
        numbers[i] = Number(scalars[i * stride]);
        if (!std::isfinite(numbers[i]))
        {
          numbers[i] = Number(0);
          allFinite = false;
        }
      }
    });
  return allFinite;
}

template <class Number>
bool CopyNumbers(const VoxelChannel& channel, Number* numbers)
{
  const vtkIdType count = channel.array->GetNumberOfTuples();
  const int stride = channel.array->GetNumberOfComponents();
  void* const scalars = channel.array->GetVoidPointer(channel.component);
  switch (channel.array->GetDataType())
  {
    vtkTemplateMacro(
      return CopyNumbers(static_cast<const VTK_TT*>(scalars), stride, count, numbers));
  }
  return true;
}

ChannelCopy CopyAs(int type, const VoxelChannel& channel)
{
  ChannelCopy copy;
  copy.array.TakeReference(vtkDataArray::CreateDataArray(type));
  copy.array->SetNumberOfTuples(channel.array->GetNumberOfTuples());
  void* const numbers = copy.array->GetVoidPointer(0);
  switch (type)
  {
    vtkTemplateMacro(copy.allFinite = CopyNumbers(channel, static_cast<VTK_TT*>(numbers)));
  }
  return copy;
}

}

ChannelCopy CopyAsItIs(const VoxelChannel& channel)
{
  return CopyAs(channel.array->GetDataType(), channel);
}

ChannelCopy CopyAsFloats(const VoxelChannel& channel)
{
  return CopyAs(VTK_FLOAT, channel);
}

ChannelCopy CopyAsDoubles(const VoxelChannel& channel)
{
  return CopyAs(VTK_DOUBLE, channel);
}

}
