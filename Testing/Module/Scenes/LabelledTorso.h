#ifndef Varimarch_Testing_LabelledTorso_h
#define Varimarch_Testing_LabelledTorso_h

#include "Core/Geometry/ScalarGrid.h"
#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/MapperScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

using Labels = std::function<int(glm::ivec3)>;

/// An image of labels by voxel.
inline vtkSmartPointer<vtkImageData> MaskOf(
  glm::ivec3 size, const Labels& labels, int type = VTK_INT)
{
  const auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(size.x, size.y, size.z);
  mask->AllocateScalars(type, 1);
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        mask->SetScalarComponentFromDouble(x, y, z, 0, labels({ x, y, z }));
      }
    }
  }
  return mask;
}

/// A torso with three labels: 1 has its own colour and opacity, 2 a gradient opacity.
class LabelledTorso
{
public:
  explicit LabelledTorso(int pictureSide = 48)
    : scene(SmallTorso(), pictureSide)
    , geometry(varimarch::VolumeGeometryOf(this->scene.image, this->scene.volume))
    , grid(static_cast<const short*>(this->scene.image->GetScalarPointer()), size)
  {
    this->scene.mapper->SetMaskInput(MaskOf(size, LabelOf, VTK_UNSIGNED_CHAR));
    this->green->AddRGBPoint(0.0, 0.1, 0.9, 0.2);
    this->veil->AddPoint(-100.0, 0.0);
    this->veil->AddPoint(300.0, 0.08);
    this->factors->AddPoint(0.0, 0.2);
    this->factors->AddPoint(100.0, 1.0);
    vtkVolumeProperty* property = this->scene.volume->GetProperty();
    property->ShadeOn();
    property->SetLabelColor(1, this->green);
    property->SetLabelScalarOpacity(1, this->veil);
    property->SetLabelGradientOpacity(2, this->factors);
  }

  /// Without light.
  varimarch::OpticalProperties LookAt(glm::dvec3 position, double value, glm::dvec3 gradient)
  {
    const int label = LabelAt(position);
    const double factor = label == 2 ? this->factors->GetValue(this->Magnitude(gradient)) : 1.0;
    const double opacity = (label == 1 ? this->veil : this->scene.opacities)->GetValue(value);
    glm::dvec3 rgb;
    (label == 1 ? this->green : this->scene.colors)->GetColor(value, &rgb.x);
    return { rgb, -std::log1p(-opacity * factor) };
  }

  varimarch::OpticalProperties MaterialAt(glm::dvec3 position, const varimarch::Ray& rayGrid)
  {
    const glm::dvec3 gradient = this->grid.Gradient(position);
    const varimarch::OpticalProperties look =
      this->LookAt(position, this->grid.Value(position), gradient);
    const glm::dvec3 normal = this->geometry.WorldFromGridNormal() * gradient;
    const glm::dvec3 toEye = this->geometry.WorldFromGridDirection() * rayGrid.direction;
    const double facing = std::abs(glm::dot(glm::normalize(normal), glm::normalize(toEye)));
    return { look.rgb * (0.1 + 0.7 * facing) + 0.2 * std::pow(facing, 10.0), look.extinction };
  }

  /// The material without a label, and otherwise that of the label.
  varimarch::OpticalProperties MaterialOver(
    const MapperScene::Material& withoutLabel, glm::dvec3 position, const varimarch::Ray& rayGrid)
  {
    return LabelAt(position) == 0 ? withoutLabel(position, rayGrid)
                                  : this->MaterialAt(position, rayGrid);
  }

  MapperScene scene;

private:
  static int LabelAt(glm::dvec3 position)
  {
    const glm::ivec3 nearest(glm::floor(position + 0.5));
    return LabelOf(glm::clamp(nearest, glm::ivec3(0), size - 1));
  }

  static int LabelOf(glm::ivec3 voxel) { return (voxel.x / 13 + voxel.z / 9) % 3; }

  // Gradient magnitude per mean spacing.
  double Magnitude(glm::dvec3 gradient) const
  {
    double spacing[3];
    this->scene.image->GetSpacing(spacing);
    const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
    return mean * glm::length(gradient / glm::dvec3(spacing[0], spacing[1], spacing[2]));
  }

  static constexpr glm::ivec3 size = glm::ivec3(40, 36, 24);
  varimarch::VolumeGeometry geometry;
  varimarch::ScalarGrid<short> grid;
  vtkNew<vtkColorTransferFunction> green;
  vtkNew<vtkPiecewiseFunction> veil;
  vtkNew<vtkPiecewiseFunction> factors;
};

#endif
