#include "ChannelCopy.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
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
          allFinite = false;
        }
      }
    });
  return allFinite;
}

template <class Array>
ChannelCopy CopyAs(const VoxelChannel& channel)
{
  const auto numbers = vtkSmartPointer<Array>::New();
  const vtkIdType count = channel.array->GetNumberOfTuples();
  numbers->SetNumberOfTuples(count);
  const int stride = channel.array->GetNumberOfComponents();
  void* const scalars = channel.array->GetVoidPointer(channel.component);
  bool allFinite = true;
  switch (channel.array->GetDataType())
  {
    vtkTemplateMacro(allFinite = CopyNumbers(
                       static_cast<const VTK_TT*>(scalars), stride, count, numbers->GetPointer(0)));
  }
  return { numbers, allFinite };
}

}

ChannelCopy CopyAsFloats(const VoxelChannel& channel)
{
  return CopyAs<vtkFloatArray>(channel);
}

ChannelCopy CopyAsDoubles(const VoxelChannel& channel)
{
  return CopyAs<vtkDoubleArray>(channel);
}

}
