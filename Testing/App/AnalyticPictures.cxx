#include "App/AnalyticPictures.h"

#include "Scene/Reference/ReferenceRequest.h"

#include <algorithm>

namespace varimarch
{

vtkSmartPointer<vtkImageData> ImageOf(const AnalyticScene& analytic)
{
  const glm::ivec3 dimensions = analytic.Dimensions();
  const glm::dvec3 spacing = analytic.spacingMm;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.x, dimensions.y, dimensions.z);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->AllocateScalars(VTK_FLOAT, 1);
  const std::vector<double> voxels = analytic.Voxels();
  std::copy(voxels.begin(), voxels.end(), static_cast<float*>(image->GetScalarPointer()));
  return image;
}

Scene SceneOf(const AnalyticScene& analytic, int size)
{
  Scene scene;
  scene.look.colors = analytic.transferFunction.Colors();
  scene.look.opacities = analytic.transferFunction.Opacities();
  scene.look.opacityUnitDistanceMm = analytic.transferFunction.OpacityUnitDistanceMm();
  scene.look.shading.enabled = false;
  scene.camera.azimuthDegrees = 30.0;
  scene.camera.elevationDegrees = 20.0;
  scene.size = { size, size };
  scene.render.earlyTerminationTransmittance = 0.0;
  return scene;
}

std::vector<float> ClosedFormPicture(const AnalyticScene& analytic, const Scene& scene)
{
  return analytic.Picture(ReferenceRequestFor(scene, ImageOf(analytic), 1.0).view);
}

}
