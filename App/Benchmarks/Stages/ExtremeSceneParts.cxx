#include "Stages/ExtremeSceneParts.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace varimarch::extreme
{

namespace
{

// Smooth, asymmetric lumps from 0 to 1, independent of the number of voxels.
double Lumps(double x, double y, double z)
{
  return 0.5 + 0.25 * std::sin(5.0 * x + 2.0 * y) + 0.25 * std::cos(4.0 * y - 3.0 * z + 1.0);
}

// A volume centred at the origin, with values from `first` to `first + range`.
vtkSmartPointer<vtkImageData> LumpyImage(
  Dimensions dimensions, int type, double first, double range, Spacing spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.data());
  image->SetSpacing(spacing.data());
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = -0.5 * (dimensions[axis] - 1) * spacing[axis];
  }
  image->SetOrigin(origin);
  image->AllocateScalars(type, 1);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  vtkIdType index = 0;
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x)
      {
        const double lumps = Lumps(double(x) / std::max(dimensions[0] - 1, 1),
          double(y) / std::max(dimensions[1] - 1, 1), double(z) / std::max(dimensions[2] - 1, 1));
        scalars->SetComponent(index++, 0, first + range * lumps);
      }
    }
  }
  return image;
}

void SetOpacities(VolumeStage& scene, const std::vector<Node>& nodes)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AllowDuplicateScalarsOn();
  for (const Node& node : nodes)
  {
    scene.opacities->AddPoint(node.value, node.opacity);
  }
}

void SetColors(VolumeStage& scene, double first, double last)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(first, 0.1, 0.5, 1.0);
  scene.colors->AddRGBPoint(last, 1.0, 0.6, 0.1);
}

}

Image Lumpy(Dimensions dimensions, int type, double first, double range, Spacing spacing)
{
  return [=] { return LumpyImage(dimensions, type, first, range, spacing); };
}

Image LumpyWith(double value, const std::vector<Dimensions>& voxels, Dimensions dimensions)
{
  return [=]
  {
    auto image = LumpyImage(dimensions, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1.0 });
    for (const auto& [x, y, z] : voxels)
    {
      image->SetScalarComponentFromDouble(x, y, z, 0, value);
    }
    return image;
  };
}

Image Constant(double value, int type)
{
  return Lumpy(SmallBox, type, value, 0.0);
}

Preparation Opacities(const std::vector<Node>& nodes, double first, double last)
{
  return [=](VolumeStage& scene)
  {
    SetColors(scene, first, last);
    SetOpacities(scene, nodes);
  };
}

Preparation LookAt(double first, double range, double opacity)
{
  return Opacities(
    { { first + 0.4 * range, 0.0 }, { first + range, opacity } }, first, first + range);
}

void UsualLook(VolumeStage& scene)
{
  LookAt(0.0, 1.0)(scene);
}

void DenseLook(VolumeStage& scene)
{
  LookAt(0.0, 1.0, 0.9)(scene);
}

Preparation UnitDistance(double distanceMm)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    scene.volume->GetProperty()->SetScalarOpacityUnitDistance(distanceMm);
  };
}

Preparation SeenFrom(const Viewpoint& view)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetPosition(view.position.data());
    camera->SetFocalPoint(view.focalPoint.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(view.angle);
    camera->SetClippingRange(view.clippingRange[0], view.clippingRange[1]);
  };
}

Preparation SeenAlong(std::array<double, 3> direction, double sideVoxels)
{
  return [=](VolumeStage& scene)
  {
    SeenFrom({ { -50.0 * direction[0], -50.0 * direction[1], -50.0 * direction[2] },
      { 0.0, 0.0, 0.0 } })(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetViewUp(0.0, direction[2] == 0.0 ? 0.0 : 1.0, direction[2] == 0.0 ? 1.0 : 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * scene.size * sideVoxels);
  };
}

}
