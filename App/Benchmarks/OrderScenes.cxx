#include "OrderScenes.h"

#include "Scene/ReferenceRequest.h"

#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double CubeSideMm = 100.0;

Scene SceneOfBytes(int side)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 0.9, 0.3, 0.1 }, {} }, { 255.0, { 0.1, 0.5, 1.0 }, {} } };
  scene.look.opacities = { { 0.0, 0.004, {} }, { 255.0, 0.04, {} } };
  scene.look.shading.enabled = false;
  scene.camera.azimuthDegrees = 25.0;
  scene.camera.elevationDegrees = 15.0;
  // Only rays through opposite faces: elsewhere their lengths, and with them the image, have kinks.
  scene.camera.zoom = 6.0;
  scene.size = { side, side };
  scene.render.acceleration = Acceleration::Off;
  scene.render.earlyTerminationTransmittance = 0.0;
  return scene;
}

}

Scene OrderScene(ProceduralKind kind, int side)
{
  constexpr int Voxels = 17;
  Scene scene = SceneOfBytes(side);
  scene.volume = ProceduralSource{ kind, { Voxels, Voxels, Voxels }, 1 };
  return scene;
}

Scene SmoothScene(int side)
{
  return SceneOfBytes(side);
}

double SmoothField(const glm::dvec3& positionMm)
{
  const glm::dvec3 p = 6.0 * positionMm / CubeSideMm;
  return 127.5 * (1.0 + std::sin(2.0 * p.x + 0.7 * p.y) * std::cos(1.7 * p.y - 1.3 * p.z));
}

vtkSmartPointer<vtkImageData> SmoothVolume(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  const double spacing = CubeSideMm / (side - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-0.5 * CubeSideMm, -0.5 * CubeSideMm, -0.5 * CubeSideMm);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const voxels = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double place[3];
    image->GetPoint(i, place);
    voxels[i] = float(SmoothField({ place[0], place[1], place[2] }));
  }
  return image;
}

vtkSmartPointer<vtkImageData> SmoothTruth(const Scene& scene, vtkImageData* image)
{
  constexpr double Tolerance = 1e-8;
  const ReferenceRequest request = ReferenceRequestFor(scene, image, Tolerance);
  ReferenceScene smooth{ {}, request.geometry.boxGrid, request.transferFunction };
  smooth.material = [&](glm::dvec3 positionGrid, const Ray&)
  {
    const glm::dvec4 world = request.geometry.worldFromGrid * glm::dvec4(positionGrid, 1.0);
    const double value = SmoothField(glm::dvec3(world));
    return OpticalProperties{ request.transferFunction.Color(value),
      request.transferFunction.Extinction(value) };
  };
  const auto drawn = DrawReference(ReferenceIntegrator(smooth, Tolerance), request.view);
  auto truth = vtkSmartPointer<vtkImageData>::New();
  truth->SetDimensions(drawn->width, drawn->height, 1);
  truth->AllocateScalars(VTK_FLOAT, 4);
  std::copy(drawn->rgba.begin(), drawn->rgba.end(), static_cast<float*>(truth->GetScalarPointer()));
  return truth;
}

}
