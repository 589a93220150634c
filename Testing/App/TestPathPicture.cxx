#include "Scene/Model/SceneLights.h"
#include "Scene/Reference/ReferencePicture.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

/// A small scene with steep opacities, seen from an oblique direction.
Scene SmallScene()
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 0.5, 0.2 } } };
  scene.look.opacities = { { 0.3, 0.0 }, { 0.5, 0.3 }, { 0.55, 0.05 }, { 1.0, 1.0 } };
  scene.look.shading.enabled = true;
  scene.camera.azimuthDegrees = 30.0;
  scene.camera.elevationDegrees = 20.0;
  scene.size = { 24, 20 };
  return scene;
}

vtkSmartPointer<vtkImageData> SmallVolume()
{
  return ProceduralVolume({ ProceduralKind::MarschnerLobb, { 14, 15, 16 } });
}

// The mean difference of a channel between two pictures, in standard errors of one of them.
double Difference(const ReferencePicture& paths, const ReferencePicture& truth, int channel)
{
  const auto* first = static_cast<const float*>(paths.image->GetScalarPointer());
  const auto* second = static_cast<const float*>(truth.image->GetScalarPointer());
  const vtkIdType count = paths.image->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType pixel = 0; pixel < count; ++pixel)
  {
    sum += first[4 * pixel + channel] - second[4 * pixel + channel];
  }
  return sum / std::sqrt(double(count)) / paths.largestError;
}

}

TEST(PathPicture, HasTheOpacitiesOfTheIntegral)
{
  Scene scene = SmallScene();
  scene.cuts.planes = { { { 7.0, 7.0, 7.0 }, { 1.0, 0.3, 0.1 } } };
  const auto image = SmallVolume();
  const ReferencePicture paths = DrawPathPicture(scene, image, { 100, 1 }).value();
  const ReferencePicture truth = DrawReferencePicture(scene, image, 1e-6).value();
  EXPECT_GT(paths.largestError, 0.01);
  EXPECT_LT(std::abs(Difference(paths, truth, 3)), 3.0);
}

// Light that is scattered once has an integral, too.
TEST(PathPicture, ScatteringOnceIsThatOfTheIntegral)
{
  Scene scene = SmallScene();
  scene.look.shading.ambient = 0.0;
  scene.look.shading.diffuse = 0.8;
  scene.look.shading.specular = 0.0;
  scene.lights = { CameraLight(60.0, 20.0) };
  scene.scattering = { 1.0, 0.5, 1.0 };
  const auto image = SmallVolume();
  const ReferencePicture paths = DrawPathPicture(scene, image, { 200, 1 }).value();
  const ReferencePicture truth = DrawReferencePicture(scene, image, 1e-4).value();
  EXPECT_LT(std::abs(Difference(paths, truth, 0)), 3.0);
  // Scattering more often adds light.
  const ReferencePicture often = DrawPathPicture(scene, image, { 200, 0 }).value();
  EXPECT_GT(Difference(often, truth, 0), 5.0);
}

TEST(PathPicture, RefusesScenesThatHaveNoLight)
{
  Scene scene = SmallScene();
  scene.look.shading.enabled = false;
  EXPECT_THROW(DrawPathPicture(scene, SmallVolume(), { 10, 1 }), std::invalid_argument);
}
