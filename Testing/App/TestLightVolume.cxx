// Shadows from a volume of light, compared with a reference that integrates the light's way to each
// sample in double precision.

#include "Benchmarks/Comparison/ComparisonVolume.h"
#include "Benchmarks/Comparison/vtkComparisonMapper.h"

#include "Core/Quality/ImageError.h"
#include "Core/Reference/LightTransmittance.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Reference/ReferenceRequest.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

// A small torso of white material, lit from the upper right.
struct TorsoInLight
{
  Scene scene = Settings();
  vtkSmartPointer<vtkImageData> image =
    ProceduralVolume({ ProceduralKind::Torso, { 40, 36, 24 }, 7 });
  OffscreenView view{ scene, image, MapperKind::VarimarchShaders };
  vtkNew<vtkComparisonMapper> mapper;

  TorsoInLight()
  {
    this->mapper->SetInputDataObject(this->image);
    this->mapper->SetMethod(vtkComparisonMapper::LightVolume);
    this->mapper->SetSampleDistance(1.0);
    this->mapper->SetLightDirection(2.0, 1.0, 1.0);
    this->view.Pipeline().Volume()->SetMapper(this->mapper);
  }

  static Scene Settings()
  {
    Scene scene;
    scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
    scene.look.opacities = { { -600.0, 0.0 }, { 1500.0, 0.25 } };
    scene.look.opacityUnitDistanceMm = 10.0;
    scene.look.shading.enabled = false;
    scene.camera.azimuthDegrees = 25.0;
    scene.camera.elevationDegrees = 15.0;
    scene.camera.parallel = true; // the distance along a ray is that of the slices
    scene.size = { 16, 14 };
    return scene;
  }

  glm::dvec3 ToLightWorld(const VolumeGeometry& geometry)
  {
    const ComparedView seen = ComparedViewOf(this->view.Pipeline().Renderer(), geometry);
    const glm::dvec3 right = glm::cross(seen.directionWorld, seen.upWorld);
    return glm::normalize(2.0 * right + seen.upWorld - seen.directionWorld);
  }

  // The volume rendering integral with shadows at each point of a ray, or without any.
  std::vector<float> Truth(bool hasShadows)
  {
    constexpr double Tolerance = 1e-3;
    const ReferenceRequest request = ReferenceRequestFor(this->scene, this->image, Tolerance);
    const TransferFunction& look = request.transferFunction;
    const ScalarGrid<short> grid(
      static_cast<const short*>(this->image->GetScalarPointer()), request.geometry.dimensions);
    ReferenceScene lit{ [&](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
      request.geometry.boxGrid, look };
    const LightTransmittance light(
      lit, glm::inverse(request.geometry.WorldFromGridDirection()), 0.1 * Tolerance);
    const glm::dvec3 toLight = this->ToLightWorld(request.geometry);
    lit.material = [&](glm::dvec3 place, const Ray&)
    {
      const double value = grid.Value(place);
      const double arriving = hasShadows ? light.Towards(place, toLight) : 1.0;
      return OpticalProperties{ look.Color(value) * arriving, look.Extinction(value) };
    };
    return DrawReference(ReferenceIntegrator(lit, Tolerance), request.view)->rgba;
  }

  double ErrorTo(const std::vector<float>& truth)
  {
    const auto picture = this->view.FloatImage();
    return CompareImages(
      static_cast<const float*>(picture->GetScalarPointer()), truth.data(), truth.size() / 4)
      .rootMeanSquare;
  }
};

}

TEST(LightVolume, HasTheShadowsOfTheReference)
{
  TorsoInLight torso;
  const std::vector<float> truth = torso.Truth(true);
  const double fine = torso.ErrorTo(truth);
  // The light is linear between voxels, which is its largest error.
  EXPECT_LT(fine, 0.5);
  torso.mapper->SetLightPoints(6);
  EXPECT_GT(torso.ErrorTo(truth), 2.0 * fine) << "light on a coarse grid";
  EXPECT_GT(torso.ErrorTo(torso.Truth(false)), 5.0) << "no shadows to be seen";
}

TEST(LightVolume, IsMadeAnewForAnotherLightAndAnotherLook)
{
  TorsoInLight torso;
  torso.mapper->SetLightPoints(20);
  const auto drawn = [&]
  {
    const auto picture = torso.view.FloatImage();
    const auto* const channels = static_cast<const float*>(picture->GetScalarPointer());
    return std::vector<float>(channels, channels + 4 * picture->GetNumberOfPoints());
  };
  const std::vector<float> first = drawn();
  const double bytes = torso.mapper->GetGraphicsMemoryBytes();
  torso.mapper->SetLightDirection(-2.0, 1.0, 1.0);
  EXPECT_NE(drawn(), first);
  torso.mapper->SetLightDirection(2.0, 1.0, 1.0);
  EXPECT_EQ(drawn(), first);
  EXPECT_EQ(torso.mapper->GetGraphicsMemoryBytes(), bytes);
  Look look = torso.scene.look;
  look.opacities.back().opacity = 0.1;
  torso.view.Pipeline().SetLook(look);
  const std::vector<float> thin = drawn();
  torso.mapper->SetLightDirection(0.0, 0.0, 1.0);
  drawn();
  torso.mapper->SetLightDirection(2.0, 1.0, 1.0);
  EXPECT_EQ(drawn(), thin) << "light of the look before";
}
