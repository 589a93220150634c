#include "Core/Quality/ImageError.h"
#include "Scene/OffscreenView.h"
#include "Scene/Presets.h"
#include "Scene/ProceduralVolume.h"

#include <vtkMatrix3x3.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

double RmseFromOurs(const Scene& scene, vtkImageData* image, MapperKind kind)
{
  OffscreenView view(scene, image, kind);
  view.Render(); // VTK's GPU mapper renders its first frame only into the window itself
  const auto picture = view.FloatImage();
  const auto ours = OffscreenView(scene, image, MapperKind::Varimarch).FloatImage();
  return CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
    static_cast<const float*>(ours->GetScalarPointer()), std::size_t(ours->GetNumberOfPoints()))
    .rootMeanSquare;
}

// A wrong light direction, a missing half or a wrong position would at least double the error.
TEST(ScenePipeline, EveryMapperDrawsATurnedAndMirroredVolumeAlike)
{
  Scene scene;
  scene.look = BuiltInPreset("ct-bone").look;
  scene.size = { 96, 96 };
  scene.camera.azimuthDegrees = 35.0;
  scene.camera.elevationDegrees = 20.0;
  scene.render.sampleDistanceMm = 1.0;
  const auto upright = ProceduralVolume({ ProceduralKind::Torso, { 64, 48, 56 }, 1 });
  const double expectedGpu = RmseFromOurs(scene, upright, MapperKind::VtkGpu);
  const double expectedCpu = RmseFromOurs(scene, upright, MapperKind::VtkCpu);
  EXPECT_LT(expectedGpu, 5.0);
  EXPECT_LT(expectedCpu, 25.0); // its rays are off by half a pixel

  const auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->ShallowCopy(upright);
  turned->SetOrigin(10.0, -20.0, 30.0);
  turned->SetDirectionMatrix(0, -0.6, 0.8, -1, 0, 0, 0, 0.8, 0.6);
  ASSERT_LT(turned->GetDirectionMatrix()->Determinant(), 0.0);
  EXPECT_LT(RmseFromOurs(scene, turned, MapperKind::VtkGpu), 1.5 * expectedGpu);
  EXPECT_LT(RmseFromOurs(scene, turned, MapperKind::VtkCpu), 1.5 * expectedCpu);
}

// The ramp rises by 10 per voxel and 5 per mm; the mean spacing is 3 mm.
TEST(ScenePipeline, GradientOpacityIsPerMillimetreWhateverTheSpacing)
{
  vtkNew<vtkImageData> ramp;
  ramp->SetDimensions(16, 16, 16);
  ramp->SetSpacing(2.0, 3.0, 4.0);
  ramp->AllocateScalars(VTK_SHORT, 1);
  auto* values = static_cast<short*>(ramp->GetScalarPointer());
  for (int i = 0; i < 16 * 16 * 16; ++i)
  {
    values[i] = short(10 * (i % 16));
  }
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 0.0, 0.5 } };
  scene.look.shading.enabled = false;
  scene.size = { 32, 32 };
  const auto alphaAt = [&](double darkBelow)
  {
    scene.look.gradientOpacities = { { darkBelow, 0.0 }, { darkBelow, 1.0 } };
    const auto picture = OffscreenView(scene, ramp, MapperKind::Varimarch).FloatImage();
    return picture->GetScalarComponentAsDouble(16, 16, 0, 3);
  };
  EXPECT_GT(alphaAt(4.5), 0.9);
  EXPECT_LT(alphaAt(5.5), 0.01);
}

}
