#ifndef Varimarch_Testing_ComponentVolumes_h
#define Varimarch_Testing_ComponentVolumes_h

#include "Module/Scenes/MapperScene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>

/// Volumes of several components, and looks for them.

using Values = std::function<double(glm::ivec3 voxel, int component)>;

inline vtkSmartPointer<vtkImageData> ImageOf(
  int type, int components, const Values& values, glm::ivec3 dimensions = { 9, 8, 7 })
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.x, dimensions.y, dimensions.z);
  image->AllocateScalars(type, components);
  for (int z = 0; z < dimensions.z; ++z)
  {
    for (int y = 0; y < dimensions.y; ++y)
    {
      for (int x = 0; x < dimensions.x; ++x)
      {
        for (int component = 0; component < components; ++component)
        {
          image->SetScalarComponentFromDouble(x, y, z, component, values({ x, y, z }, component));
        }
      }
    }
  }
  return image;
}

// Looks along z through the whole thickness of a volume.
inline void LookAlongZ(MapperScene& scene)
{
  double center[3];
  scene.image->GetCenter(center);
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0], center[1], 1000.0);
  camera->SetClippingRange(1.0, 2000.0);
}

// Appearance of a component: a constant colour, and an opacity that rises from 0 with the value.
struct ComponentLook
{
  glm::dvec3 color;
  double lowest;
  double highest;
  double opacity; ///< opacity at the highest value
};

inline void SetLook(vtkVolumeProperty* property, int component, const ComponentLook& look)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, look.color.r, look.color.g, look.color.b);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(look.lowest, 0.0);
  opacity->AddPoint(look.highest, look.opacity);
  property->SetColor(component, color);
  property->SetScalarOpacity(component, opacity);
}

inline double OpacityOf(const ComponentLook& look, double value)
{
  const double part = (value - look.lowest) / (look.highest - look.lowest);
  return look.opacity * std::clamp(part, 0.0, 1.0);
}

inline const ComponentLook looks[] = { { { 1.0, 0.2, 0.1 }, 0.0, 100.0, 0.1 },
  { { 0.1, 0.9, 0.3 }, 20.0, 120.0, 0.2 }, { { 0.2, 0.3, 1.0 }, 10.0, 90.0, 0.15 },
  { { 0.9, 0.8, 0.1 }, 50.0, 150.0, 0.3 } };

// Two overlapping balls with soft rims, one for each component.
inline double BallValue(glm::ivec3 voxel, int component)
{
  const glm::dvec3 center(component == 0 ? 6.0 : 10.0, 8.0, component == 0 ? 7.0 : 9.0);
  return 150.0 - 14.0 * glm::length(glm::dvec3(voxel) - center);
}

#endif
