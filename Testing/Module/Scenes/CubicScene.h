#ifndef Varimarch_Testing_CubicScene_h
#define Varimarch_Testing_CubicScene_h

#include "Core/Reference/SplineGrid.h"
#include "Frame/PropertyTransferFunction.h"
#include "Module/Scenes/MapperScene.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

/// An edge with a little noise behind a wide veil, so that overshoots are visible.
inline vtkSmartPointer<vtkImageData> NoisyEdge(int type)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(14, 11, 9);
  image->SetSpacing(1.0, 1.2, 1.6);
  image->AllocateScalars(type, 1);
  std::mt19937 random(2);
  std::uniform_int_distribution<int> noise(0, 60);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (int i = 0; i < 14 * 11 * 9; ++i)
  {
    const int x = i % 14;
    const int z = i / (14 * 11);
    scalars->SetComponent(i, 0, (x + z > 10 ? 220 : 20) + noise(random));
  }
  return image;
}

inline varimarch::SplineGrid SplineOf(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  std::vector<double> voxels(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = scalars->GetComponent(vtkIdType(i), 0);
  }
  const int* const dimensions = image->GetDimensions();
  return varimarch::SplineGrid(voxels, { dimensions[0], dimensions[1], dimensions[2] });
}

/// A volume of cubic interpolation, with its true image.
class CubicScene : public MapperScene
{
public:
  explicit CubicScene(vtkImageData* image, int size = 48)
    : MapperScene(image, size)
    , spline(SplineOf(image))
  {
    this->mapper->CubicInterpolationOn();
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 0.1, 0.2, 1.0);
    this->colors->AddRGBPoint(300.0, 1.0, 0.8, 0.1);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(-40.0, 0.3); // shows values that only undershoots reach
    this->opacities->AddPoint(0.0, 0.0);
    this->opacities->AddPoint(150.0, 0.0);
    this->opacities->AddPoint(320.0, 0.5);
  }

  /// The true image's material: the spline, lit by its own gradient.
  Material Truth()
  {
    const varimarch::VolumeGeometry geometry =
      varimarch::VolumeGeometryOf(this->image, this->volume);
    const varimarch::TransferFunction function =
      varimarch::TransferFunctionOf(this->volume->GetProperty());
    const bool shaded = this->volume->GetProperty()->GetShade() != 0;
    return [this, geometry, function, shaded](glm::dvec3 position, const varimarch::Ray& ray)
    {
      const double value = this->spline.Value(position);
      varimarch::OpticalProperties properties{ function.Color(value), function.Extinction(value) };
      if (shaded)
      {
        const glm::dvec3 normal =
          glm::normalize(geometry.WorldFromGridNormal() * this->spline.Gradient(position));
        const glm::dvec3 toEye = glm::normalize(geometry.WorldFromGridDirection() * ray.direction);
        const double facing = std::abs(glm::dot(normal, toEye));
        properties.rgb = properties.rgb * (0.1 + 0.7 * facing) + 0.2 * std::pow(facing, 10.0);
      }
      return properties;
    };
  }

  varimarch::SplineGrid spline;
};

#endif
