#include "Core/HeadLightShading.h"
#include "Core/ImageError.h"
#include "Core/ReferenceImage.h"
#include "Scene/OffscreenView.h"
#include "Scene/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

using namespace varimarch;

namespace
{

/// A picture small enough for a test, of a volume with as many voxels across as it has pixels.
Scene SceneOf(Blend blend, bool shading)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 0.2, 0.1 } }, { 0.5, { 0.2, 1.0, 0.3 } },
    { 1.0, { 0.2, 0.3, 1.0 } } };
  scene.look.opacities = { { 0.1, 0.0 }, { 0.4, 0.02 }, { 0.7, 0.01 }, { 1.0, 0.3 } };
  scene.look.shading.enabled = shading;
  scene.look.blend = blend;
  scene.camera.azimuthDegrees = 30.0;
  scene.camera.elevationDegrees = 20.0;
  scene.size = { 60, 50 };
  scene.render.acceleration = Acceleration::Off;
  scene.render.earlyTerminationTransmittance = 0.0;
  return scene;
}

ReferenceScene ReferenceSceneOf(const Scene& scene, const ScalarGrid<float>& grid)
{
  const glm::dmat3 worldFromGrid(
    glm::scale(glm::dmat4(1.0), grid.SpacingMm())); // no volume here is turned
  const ScalarGrid<float> unitGrid(grid.Voxels(), grid.Dimensions());
  ReferenceScene reference{ [grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    { glm::dvec3(0.0), glm::dvec3(grid.Dimensions() - 1) },
    TransferFunction(scene.look.colors, scene.look.opacities, scene.look.opacityUnitDistanceMm),
    scene.look.blend };
  if (const Shading& shading = scene.look.shading; shading.enabled)
  {
    const HeadLight light{ glm::dvec3(shading.ambient), glm::dvec3(shading.diffuse),
      glm::dvec3(shading.specular), shading.specularPower };
    reference.shade = HeadLightShading(
      light, [unitGrid](glm::dvec3 position) { return unitGrid.Gradient(position); },
      worldFromGrid);
  }
  return reference;
}

/// The error of the mapper's picture with one sample per distance.
ImageError ErrorAtDistance(Scene scene, double sampleDistanceMm)
{
  const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 40, 44, 48 } });
  const glm::dvec3 spacing = glm::make_vec3(image->GetSpacing());
  const ScalarGrid<float> grid(static_cast<const float*>(image->GetScalarPointer()),
    glm::make_vec3(image->GetDimensions()), spacing);

  scene.render.sampleDistanceMm = sampleDistanceMm;
  OffscreenView view(scene, image, MapperKind::Varimarch);
  const auto picture = view.FloatImage();

  const double aspect = double(scene.size[0]) / scene.size[1];
  vtkCamera* camera = view.Pipeline().Renderer()->GetActiveCamera();
  const glm::dmat4 clipFromWorld = glm::transpose(
    glm::make_mat4(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->GetData()));
  const glm::dmat4 worldFromGrid =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::make_vec3(image->GetOrigin())), spacing);
  const ReferenceScene referenceScene = ReferenceSceneOf(scene, grid);
  const ReferenceView referenceView{ ComputePixelRays(
                                       clipFromWorld * worldFromGrid, referenceScene.boxGrid),
    glm::dmat3(worldFromGrid), scene.size[0], scene.size[1] };
  const auto truth = DrawReference(ReferenceIntegrator(referenceScene, 1e-6), referenceView);
  return CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
    truth.value().rgba.data(), std::size_t(scene.size[0]) * scene.size[1]);
}

}

// The two share no formula: agreement to thousandths of a step of 8 bits leaves no room for a wrong
// ray, voxel position, opacity correction or light.

TEST(PictureAgainstReference, CompositeConvergesToTheIntegral)
{
  const Scene scene = SceneOf(Blend::Composite, false);
  const double coarse = ErrorAtDistance(scene, 0.8).rootMeanSquare;
  const ImageError fine = ErrorAtDistance(scene, 0.1);
  EXPECT_LT(fine.rootMeanSquare, 0.003);
  EXPECT_LT(fine.largest, 0.05);
  EXPECT_LT(fine.rootMeanSquare, coarse / 16.0) << "at least order 4 / 3; 2 where all is smooth";
}

TEST(PictureAgainstReference, ShadedCompositeConvergesToTheIntegral)
{
  const Scene scene = SceneOf(Blend::Composite, true);
  const ImageError fine = ErrorAtDistance(scene, 0.1);
  EXPECT_LT(fine.rootMeanSquare, 0.03);
  EXPECT_LT(fine.largest, 2.0);
}

TEST(PictureAgainstReference, MaximumConvergesToTheLargestValue)
{
  const Scene scene = SceneOf(Blend::MaximumIntensity, false);
  const ImageError fine = ErrorAtDistance(scene, 0.05);
  EXPECT_LT(fine.rootMeanSquare, 0.1);
  EXPECT_LT(fine.largest, 1.0);
}
