#include "Resources/SplineVolume.h"

#include "Core/Geometry/SplineCoefficients.h"
#include "Resources/ChannelCopy.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <stdexcept>

namespace varimarch
{

namespace
{

template <class Coefficient>
vtkSmartPointer<vtkDataArray> CoefficientsOf(const ChannelCopy& voxels, glm::ivec3 dimensions)
{
  if (!voxels.allFinite)
  {
    throw std::runtime_error("Cubic interpolation of voxels that are not finite is not supported");
  }
  auto* const coefficients = static_cast<Coefficient*>(voxels.array->GetVoidPointer(0));
  TurnIntoSplineCoefficients(coefficients, dimensions);
  return voxels.array;
}

}

SplineVolume::SplineVolume(const VoxelChannels& channels, glm::ivec3 dimensions)
{
  for (const VoxelChannel& channel : channels)
  {
    // Floats have all digits of floats and of 16 bit integers.
    const bool single =
      channel.array->GetDataType() == VTK_FLOAT || channel.array->GetDataTypeSize() <= 2;
    this->coefficients.push_back(single
        ? CoefficientsOf<float>(CopyAsFloats(channel), dimensions)
        : CoefficientsOf<double>(CopyAsDoubles(channel), dimensions));
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
