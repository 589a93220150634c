#include "SplineVolume.h"

#include "Core/SplineCoefficients.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace varimarch
{

namespace
{

/// @return whether all are finite
template <class Scalar, class Coefficient>
bool CopyChannel(const Scalar* scalars, int stride, vtkIdType count, Coefficient* coefficients)
{
  constexpr vtkIdType AtOnce = 1 << 16;
  std::atomic<bool> allFinite = true;
  tbb::parallel_for(vtkIdType(0), count, AtOnce,
    [&](vtkIdType first)
    {
      for (vtkIdType i = first; i < std::min(first + AtOnce, count); ++i)
      {
        coefficients[i] = Coefficient(scalars[i * stride]);
        if (!std::isfinite(coefficients[i]))
        {
          allFinite = false;
        }
      }
    });
  return allFinite;
}

template <class Array>
vtkSmartPointer<vtkDataArray> CoefficientsOf(const VoxelChannel& channel, glm::ivec3 dimensions)
{
  const auto coefficients = vtkSmartPointer<Array>::New();
  const vtkIdType count = channel.array->GetNumberOfTuples();
  coefficients->SetNumberOfTuples(count);
  const int stride = channel.array->GetNumberOfComponents();
  void* const voxels = channel.array->GetVoidPointer(channel.component);
  bool allFinite = true;
  switch (channel.array->GetDataType())
  {
    vtkTemplateMacro(allFinite = CopyChannel(static_cast<const VTK_TT*>(voxels), stride, count,
                       coefficients->GetPointer(0)));
  }
  if (!allFinite)
  {
    throw std::runtime_error("Cubic interpolation of voxels that are not finite is not supported");
  }
  TurnIntoSplineCoefficients(coefficients->GetPointer(0), dimensions);
  return coefficients;
}

}

SplineVolume::SplineVolume(const VoxelChannels& channels, glm::ivec3 dimensions)
{
  for (const VoxelChannel& channel : channels)
  {
    // Floats have all digits of floats and of 16 bit integers.
    const bool single =
      channel.array->GetDataType() == VTK_FLOAT || channel.array->GetDataTypeSize() <= 2;
    this->coefficients.push_back(single ? CoefficientsOf<vtkFloatArray>(channel, dimensions)
                                        : CoefficientsOf<vtkDoubleArray>(channel, dimensions));
  }
}

VoxelChannels SplineVolume::Channels() const
{
  VoxelChannels channels;
  for (const auto& array : this->coefficients)
  {
    channels.push_back({ array, 0 });
  }
  return channels;
}

std::vector<ScalarTexels> SplineVolume::Texels(const VoxelChannels& voxels) const
{
  std::vector<ScalarTexels> texels = ScalarTexelsOf(this->Channels());
  const std::vector<ScalarTexels> texelsOfVoxels = ScalarTexelsOf(voxels);
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    texels[i].smallestScalar = texelsOfVoxels[i].smallestScalar;
    texels[i].largestScalar = texelsOfVoxels[i].largestScalar;
    texels[i].finite = true;
  }
  return texels;
}

}
