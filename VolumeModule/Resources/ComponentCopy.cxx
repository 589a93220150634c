#include "Resources/ComponentCopy.h"

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

/// Copies numbers with a stride, replacing non-finite ones by 0.
/// @return true if all are finite
template <class Number, class Scalar>
bool CopyNumbers(const void* source, int stride, vtkIdType count, void* target)
{
  const auto* const scalars = static_cast<const Scalar*>(source);
  auto* const numbers = static_cast<Number*>(target);
  bool allFinite = true;
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers[i] = Number(scalars[i * stride]);
    if (!std::isfinite(numbers[i]))
    {
      numbers[i] = Number(0);
      allFinite = false;
    }
  }
  return allFinite;
}

/// Copies scalars with a stride as texels, which are 0 where a scalar is not finite.
/// @return true if all are finite
template <class Scalar>
bool CopyTexels(
  const void* source, int stride, vtkIdType count, void* target, const TexelMapping& mapping)
{
  const auto* const scalars = static_cast<const Scalar*>(source);
  auto* const texels = static_cast<float*>(target);
  bool allFinite = true;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double texel = mapping.TexelOf(double(scalars[i * stride]));
    const bool isFinite = std::isfinite(double(scalars[i * stride]));
    texels[i] = isFinite ? float(std::clamp(texel, -LargestTexel, LargestTexel)) : 0.0f;
    allFinite = allFinite && isFinite;
  }
  return allFinite;
}

// CopyNumbers and CopyTexels for types that are chosen at run time, so that the parallel loop is
// compiled only once.
using NumberCopier = bool (*)(const void* source, int stride, vtkIdType count, void* target);
using TexelCopier = bool (*)(
  const void* source, int stride, vtkIdType count, void* target, const TexelMapping& mapping);

TexelCopier TexelCopierFrom(int vtkType)
{
  switch (vtkType)
  {
    vtkTemplateMacro(return &CopyTexels<VTK_TT>);
  }
  return nullptr;
}

/// @param vtkType  a numeric type
template <class Number>
NumberCopier NumberCopierFrom(int vtkType)
{
  switch (vtkType)
  {
    vtkTemplateMacro(return (&CopyNumbers<Number, VTK_TT>));
  }
  return nullptr;
}

NumberCopier NumberCopierOf(int fromType, int toType)
{
  switch (toType)
  {
    case VTK_FLOAT:
      return NumberCopierFrom<float>(fromType);
    case VTK_DOUBLE:
      return NumberCopierFrom<double>(fromType);
  }
  switch (fromType)
  {
    vtkTemplateMacro(return (&CopyNumbers<VTK_TT, VTK_TT>));
  }
  return nullptr;
}

/// @param type  the type of the copy
/// @param copyNumbers  copies a number of values with a stride
template <class Copier>
ComponentCopy CopyBy(const Copier& copyNumbers, int type, const VoxelComponent& component)
{
  const vtkIdType count = component.array->GetNumberOfTuples();
  ComponentCopy copy;
  copy.array.TakeReference(vtkDataArray::CreateDataArray(type));
  copy.array->SetNumberOfTuples(count);

  const int stride = component.array->GetNumberOfComponents();
  const auto* const scalars =
    static_cast<const char*>(component.array->GetVoidPointer(component.index));
  const std::size_t tupleBytes = std::size_t(stride) * component.array->GetDataTypeSize();
  auto* const numbers = static_cast<char*>(copy.array->GetVoidPointer(0));
  const std::size_t numberBytes = copy.array->GetDataTypeSize();
  std::atomic<bool> allFinite = true;
  constexpr vtkIdType AtOnce = 1 << 16;
  tbb::parallel_for(vtkIdType(0), count, AtOnce,
    [&](vtkIdType first)
    {
      if (!copyNumbers(scalars + first * tupleBytes, stride, std::min(AtOnce, count - first),
            numbers + first * numberBytes))
      {
        allFinite = false;
      }
    });
  copy.allFinite = allFinite;
  return copy;
}

/// @param type  VTK_FLOAT, VTK_DOUBLE, or the component's own type
ComponentCopy CopyAs(int type, const VoxelComponent& component)
{
  return CopyBy(NumberCopierOf(component.array->GetDataType(), type), type, component);
}

}

ComponentCopy CopyAsItIs(const VoxelComponent& component)
{
  return CopyAs(component.array->GetDataType(), component);
}

ComponentCopy CopyAsFloats(const VoxelComponent& component)
{
  return CopyAs(VTK_FLOAT, component);
}

ComponentCopy CopyAsTexels(const VoxelComponent& component, const TexelMapping& mapping)
{
  const TexelCopier copyTexels = TexelCopierFrom(component.array->GetDataType());
  const auto copy = [&](const void* source, int stride, vtkIdType count, void* target)
  { return copyTexels(source, stride, count, target, mapping); };
  return CopyBy(copy, VTK_FLOAT, component);
}

ComponentCopy CopyAsDoubles(const VoxelComponent& component)
{
  return CopyAs(VTK_DOUBLE, component);
}

}
