#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkLightCollection.h>
#include <vtkMatrix3x3.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <gtest/gtest.h>

#include <cmath>

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

// The ramp rises by 10 per voxel and 5 per mm; the mean spacing is 3 mm.
vtkSmartPointer<vtkImageData> Ramp()
{
  auto ramp = vtkSmartPointer<vtkImageData>::New();
  ramp->SetDimensions(16, 16, 16);
  ramp->SetSpacing(2.0, 3.0, 4.0);
  ramp->AllocateScalars(VTK_SHORT, 1);
  auto* values = static_cast<short*>(ramp->GetScalarPointer());
  for (int i = 0; i < 16 * 16 * 16; ++i)
  {
    values[i] = short(10 * (i % 16));
  }
  return ramp;
}

// An opaque ball with a radius of 13 mm, whose centre is the origin.
vtkSmartPointer<vtkImageData> Ball()
{
  constexpr int Side = 33;
  auto ball = vtkSmartPointer<vtkImageData>::New();
  ball->SetDimensions(Side, Side, Side);
  ball->SetOrigin(-16.0, -16.0, -16.0);
  ball->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(ball->GetScalarPointer());
  for (int i = 0; i < Side * Side * Side; ++i)
  {
    const double x = i % Side - 16.0;
    const double y = i / Side % Side - 16.0;
    const double z = i / (Side * Side) - 16.0;
    value[i] = float(100.0 - 6.0 * std::sqrt(x * x + y * y + z * z));
  }
  return ball;
}

// The ball from the front in a parallel projection, so that all rays to the eye have one direction.
Scene LitScene()
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 20.0, 0.0 }, { 24.0, 0.99 } };
  scene.look.shading = { true, 0.1, 0.7, 0.2, 10.0 };
  scene.size = { 64, 64 };
  scene.camera.view = View::Anterior;
  scene.camera.parallel = true;
  scene.render.sampleDistanceMm = 0.25;
  return scene;
}

// Brightness of the right half of an image divided by that of its left half.
double RightByLeft(const Scene& scene, vtkImageData* image)
{
  const auto picture = OffscreenView(scene, image, MapperKind::Varimarch).FloatImage();
  std::array<double, 2> sums = {};
  for (int pixel = 0; pixel < 64 * 64; ++pixel)
  {
    sums[pixel % 64 / 32] += picture->GetScalarComponentAsDouble(pixel % 64, pixel / 64, 0, 0);
  }
  return sums[1] / sums[0];
}

double LargestDifference(const Scene& a, const Scene& b, vtkImageData* image)
{
  const auto first = OffscreenView(a, image, MapperKind::Varimarch).FloatImage();
  const auto second = OffscreenView(b, image, MapperKind::Varimarch).FloatImage();
  return CompareImages(static_cast<const float*>(first->GetScalarPointer()),
    static_cast<const float*>(second->GetScalarPointer()), std::size_t(first->GetNumberOfPoints()))
    .largest;
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

TEST(ScenePipeline, GradientOpacityIsPerMillimetreWhateverTheSpacing)
{
  const auto ramp = Ramp();
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

// A light far in front of the patient lights as one at an eye there does, except that this one also
// lights the backs of surfaces, which rays see at the rim of the ball. Differences are of 255.
TEST(ScenePipeline, LightsOfAllKindsInOneDirectionLightAlike)
{
  constexpr double FarMm = 1e7;
  constexpr double AtTheRim = 4.0;
  const auto ball = Ball();
  const Scene head = LitScene();
  const SceneLight lights[] = { SceneLight(), { LightKind::Camera, { 0.0, 0.0, 3.0 } },
    { LightKind::Directional, { 0.0, -0.5, 0.0 } },
    { LightKind::Positional, SceneLight().direction, { 0.0, -FarMm, 0.0 } } };
  for (const SceneLight& light : lights)
  {
    Scene lit = head;
    lit.lights = { light };
    EXPECT_LT(LargestDifference(head, lit, ball), AtTheRim) << int(light.kind);
    lit.lights.front().rgb = { 0.5, 1.0, 1.0 };
    EXPECT_GT(LargestDifference(head, lit, ball), 50.0) << "colours count";
    lit.lights = { light, light };
    lit.lights[0].intensity = lit.lights[1].intensity = 0.5;
    EXPECT_LT(LargestDifference(head, lit, ball), AtTheRim) << "two halves are a whole";
  }
}

TEST(ScenePipeline, ALightFromTheSideLeavesTheOtherSideToAmbientLight)
{
  const auto ball = Ball();
  Scene scene = LitScene();
  EXPECT_NEAR(RightByLeft(scene, ball), 1.0, 0.01);
  scene.lights = { CameraLight(90.0, 0.0) };
  EXPECT_GT(RightByLeft(scene, ball), 3.0);
  scene.lights = { { LightKind::Directional, { -1.0, 0.0, 0.0 } } };
  EXPECT_LT(RightByLeft(scene, ball), 1.0 / 3.0) << "the patient's right is on the left";
  scene.lights = { CameraLight(90.0, 0.0), CameraLight(-90.0, 0.0) };
  EXPECT_NEAR(RightByLeft(scene, ball), 1.0, 0.01);
  ScenePipeline theirs(scene, ball, MapperKind::VtkGpu);
  EXPECT_EQ(theirs.Renderer()->GetLights()->GetNumberOfItems(), 2) << "VTK gets them too";
  theirs.SetLights({});
  EXPECT_EQ(theirs.Renderer()->GetLights()->GetNumberOfItems(), 0) << "it makes its own";
}

TEST(ScenePipeline, AnglesOfLightsAreThoseOfTheirDirections)
{
  for (const LightKind kind : { LightKind::Camera, LightKind::Directional })
  {
    const LightAngles angles = AnglesOf(DirectionOf({ -120.0, 35.0 }, kind), kind);
    EXPECT_NEAR(angles.azimuthDegrees, -120.0, 1e-9);
    EXPECT_NEAR(angles.elevationDegrees, 35.0, 1e-9);
  }
  EXPECT_NEAR(DirectionOf({ 90.0, 0.0 }, LightKind::Directional)[0], 1.0, 1e-12) << "left";
  EXPECT_NEAR(DirectionOf({ 0.0, 0.0 }, LightKind::Directional)[1], -1.0, 1e-12) << "front";
  EXPECT_NEAR(DirectionOf({ 0.0, 90.0 }, LightKind::Directional)[2], 1.0, 1e-12) << "head";
}

// The gradient is 5 per mm, so a damping of 10 per mm halves the diffuse light that hits the ramp
// from below.
TEST(ScenePipeline, DampingIsPerMillimetreWhateverTheSpacing)
{
  const auto ramp = Ramp();
  Scene scene = LitScene();
  scene.camera.view = View::Right;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 40.0, 0.0 }, { 40.0, 0.5 } }; // the outermost voxels are less steep
  scene.look.shading = { true, 0.0, 1.0, 0.0, 1.0 };
  const auto brightness = [&](double damping)
  {
    scene.look.dampingGradient = damping;
    const auto picture = OffscreenView(scene, ramp, MapperKind::Varimarch).FloatImage();
    return picture->GetScalarComponentAsDouble(32, 32, 0, 0) /
      picture->GetScalarComponentAsDouble(32, 32, 0, 3);
  };
  EXPECT_NEAR(brightness(0.0), 1.0, 0.01);
  EXPECT_NEAR(brightness(4.0), 1.0, 0.01);
  EXPECT_NEAR(brightness(10.0), 0.5, 0.01);
}

// The box is 30 mm wide, and each mm of it takes a twentieth of the light.
TEST(ScenePipeline, TheClippingRangeIsThePartThatIsDrawn)
{
  const auto ramp = Ramp();
  Scene scene = LitScene();
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 0.0, 0.05 } };
  scene.look.shading.enabled = false;
  scene.camera.pose =
    CameraPose{ { -100.0, 22.0, 30.0 }, { 15.0, 22.0, 30.0 }, { 0.0, 0.0, 1.0 }, 30.0 };
  const auto alpha = [&](std::array<double, 2> range)
  {
    scene.camera.clippingRangeMm = range;
    const auto picture = OffscreenView(scene, ramp, MapperKind::Varimarch).FloatImage();
    return picture->GetScalarComponentAsDouble(32, 32, 0, 3);
  };
  constexpr double HalfByte = 0.5 / 255.0;
  EXPECT_NEAR(alpha({ 1.0, 1000.0 }), 1.0 - std::pow(0.95, 30.0), 1.0 / 64.0);
  EXPECT_NEAR(alpha({ 104.0, 114.0 }), 1.0 - std::pow(0.95, 10.0), HalfByte);
  EXPECT_NEAR(alpha({ 1.0, 108.0 }), 1.0 - std::pow(0.95, 8.0), HalfByte);
}

TEST(ScenePipeline, InterpolationAndJitterReachTheMappersThatHaveThem)
{
  Scene scene = LitScene();
  scene.render.interpolation = Interpolation::Cubic;
  scene.render.jitter = true;
  const auto ramp = Ramp();
  ScenePipeline ours(scene, ramp, MapperKind::Varimarch);
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(ours.Mapper());
  EXPECT_TRUE(mapper->GetCubicInterpolation());
  EXPECT_TRUE(mapper->GetUseJittering());
  Look surfaces = scene.look;
  surfaces.blend = Blend::Isosurface;
  surfaces.isosurfaces = { { 50.0, { 1.0, 1.0, 1.0 } } };
  ours.SetLook(surfaces);
  EXPECT_FALSE(mapper->GetCubicInterpolation()) << "the mapper refuses it for isosurfaces";
  ours.SetLook(scene.look);
  EXPECT_TRUE(mapper->GetCubicInterpolation());
  scene.render.interpolation = Interpolation::Nearest;
  ours.SetRenderOptions(scene.render);
  ours.SetLook(scene.look);
  EXPECT_FALSE(mapper->GetCubicInterpolation());
  EXPECT_EQ(ours.Volume()->GetProperty()->GetInterpolationType(), VTK_NEAREST_INTERPOLATION);
  ScenePipeline theirs(scene, ramp, MapperKind::VtkGpu);
  EXPECT_EQ(theirs.Volume()->GetProperty()->GetInterpolationType(), VTK_NEAREST_INTERPOLATION);
  EXPECT_TRUE(vtkGPUVolumeRayCastMapper::SafeDownCast(theirs.Mapper())->GetUseJittering());
}

}
