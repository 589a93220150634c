#include "Resources/SplineVolume.h"

#include "Core/Geometry/SplineCoefficients.h"
#include "Resources/ComponentCopy.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <stdexcept>

namespace varimarch
{

namespace
{

template <class Coefficient>
vtkSmartPointer<vtkDataArray> CoefficientsOf(const ComponentCopy& voxels, glm::ivec3 dimensions)
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

SplineVolume::SplineVolume(const VoxelComponents& components, glm::ivec3 dimensions)
{
  for (const VoxelComponent& component : components)
  {
    // Floats are precise enough for floats and for integers of up to 16 bits.
    const bool single =
      component.array->GetDataType() == VTK_FLOAT || component.array->GetDataTypeSize() <= 2;
    this->coefficients.push_back(single
        ? CoefficientsOf<float>(CopyAsFloats(component), dimensions)
        : CoefficientsOf<double>(CopyAsDoubles(component), dimensions));
  }
}

VoxelComponents SplineVolume::Components() const
{
  VoxelComponents components;
  for (const auto& array : this->coefficients)
  {
    components.push_back({ array, 0 });
  }
  return components;
}

std::vector<ScalarTexels> SplineVolume::Texels(const VoxelComponents& voxels) const
{
  std::vector<ScalarTexels> texels = ScalarTexelsOf(this->Components());
  const std::vector<ScalarTexels> texelsOfVoxels = ScalarTexelsOf(voxels);
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    texels[i].smallestScalar = texelsOfVoxels[i].smallestScalar;
    texels[i].largestScalar = texelsOfVoxels[i].largestScalar;
    texels[i].gray = texelsOfVoxels[i].gray;
    texels[i].finite = true;
  }
  return texels;
}

}
