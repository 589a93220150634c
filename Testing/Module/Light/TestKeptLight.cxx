// Light in matter that changes within a voxel, where lattices of light are wrong at or between
// their nodes, compared with a reference in double precision.

#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double Tolerance = 1.0 / 64.0;
constexpr double TruthTolerance = 1e-3;

using Values = std::function<double(int x, int y, int z)>;
using Nodes = std::vector<std::pair<double, double>>;

vtkSmartPointer<vtkImageData> ImageOf(int side, const Values& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  vtkNew<vtkFloatArray> scalars;
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        scalars->InsertNextValue(float(values(x, y, z)));
      }
    }
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// A band of opacity across each voxel of values that rise by 1 / side along an axis. Bands are more
// opaque from voxel to voxel: between equal ones no side of a surface has less matter.
Nodes BandsOfVoxels(int side, double mostOpacity)
{
  Nodes nodes;
  for (int voxel = 1; voxel < side - 1; ++voxel)
  {
    const double middle = voxel + 0.5;
    const double opacity = mostOpacity * (0.4 + 0.6 * voxel / side);
    nodes.emplace_back((middle - 0.2) / side, 0.0);
    nodes.emplace_back((middle - 0.1) / side, opacity);
    nodes.emplace_back((middle + 0.1) / side, opacity);
    nodes.emplace_back((middle + 0.2) / side, 0.0);
  }
  return nodes;
}

class FineMatter : public MapperScene
{
public:
  FineMatter(int side, const Values& values, const Nodes& nodes)
    : MapperScene(ImageOf(side, values), 8)
  {
    this->opacities->RemoveAllPoints();
    for (const auto& [value, opacity] : nodes)
    {
      this->opacities->AddPoint(value, opacity);
    }
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
    this->volume->GetProperty()->ShadeOn();
    this->volume->GetProperty()->SetAmbient(0.0);
    this->volume->GetProperty()->SetDiffuse(1.0);
    this->mapper->SetErrorTolerance(Tolerance);
    this->renderer->AutomaticLightCreationOff();
    this->renderer->RemoveAllLights();
    vtkCamera* const camera = this->renderer->GetActiveCamera();
    camera->Azimuth(20.0);
    camera->Elevation(25.0);
    this->renderer->ResetCamera();
  }

  void Occlude(double reachMm)
  {
    this->mapper->SetAmbientOcclusion(1.0);
    this->mapper->SetAmbientOcclusionReach(reachMm);
    AddLight(this->renderer, { 3.0, -20.0, 100.0 }, glm::dvec3(0.0));
  }

  void LightAlong(glm::dvec3 direction)
  {
    this->mapper->ShadowsOn();
    this->mapper->SetVolumetricScatteringBlending(1.0);
    AddLight(this->renderer, -1000.0 * direction, glm::dvec3(0.0));
  }

  void ExpectPromise(const Material& material)
  {
    const std::vector<float> drawn = this->DrawByProcessor();
    EXPECT_TRUE(this->mapper->GetErrorToleranceIsKept());
    const std::vector<float> truth = this->TruthOf(material, TruthTolerance);
    EXPECT_LT(
      CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999, 255.0 * Tolerance);
  }
};

}

TEST(KeptLight, OfOcclusionBetweenBandsKeepsTheTolerance)
{
  FineMatter bands(
    8, [](int, int, int z) { return z / 8.0; }, BandsOfVoxels(8, 0.7));
  bands.Occlude(4.0);
  bands.ExpectPromise(OccludedMaterial(bands, TruthTolerance));
}

TEST(KeptLight, OfOcclusionBetweenThinWallsKeepsTheTolerance)
{
  FineMatter walls(12,
    [](int x, int y, int z)
    { return (x % 3 == 1 && y > 2) || (z % 5 == 2 && x > 6) ? 1.0 : 0.01 * ((7 * x + 3 * y) % 9); },
    { { 0.3, 0.0 }, { 0.8, 0.95 } });
  walls.Occlude(6.0);
  walls.ExpectPromise(OccludedMaterial(walls, TruthTolerance));
}

TEST(KeptLight, ThroughBandsKeepsTheTolerance)
{
  FineMatter bands(
    16, [](int, int, int z) { return z / 16.0; }, BandsOfVoxels(16, 0.2));
  bands.LightAlong({ 0.02, 0.03, -1.0 });
  bands.ExpectPromise(MaterialInOwnShadows(bands, TruthTolerance));
}

TEST(KeptLight, AlongASheetBetweenNodesKeepsTheTolerance)
{
  FineMatter sheet(16, [](int x, int, int z) { return x == 7 && z > 6 ? 0.9 : 0.4; },
    { { 0.3, 0.06 }, { 0.5, 0.06 }, { 0.7, 0.3 }, { 0.9, 0.9 } });
  sheet.LightAlong({ 0.0, 0.0, -1.0 });
  sheet.ExpectPromise(MaterialInOwnShadows(sheet, TruthTolerance));
}

// Behind matter that is opaque in a few steps, some rays see nothing while others gather light.
TEST(KeptLight, BehindOpaqueMatterIsFinite)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  FineMatter noise(
    10, [&](int, int, int) { return value(random); }, { { 0.32, 0.0 }, { 0.42, 1.0 } });
  noise.LightAlong({ 0.3, 0.5, -1.0 });
  const ExpectedVtkErrors messages; // the tolerance may be missed
  for (const float channel : noise.DrawByProcessor())
  {
    ASSERT_TRUE(std::isfinite(channel));
  }
}

// Rays through boxes of voxels have no steps. Below a tolerance of 1/128, all light is traced.
TEST(KeptLight, OfOcclusionOfBoxesIsTried)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  FineMatter noise(
    10, [&](int, int, int) { return value(random); }, { { 0.5, 0.0 }, { 0.7, 0.9 } });
  noise.volume->GetProperty()->SetInterpolationTypeToNearest();
  noise.Occlude(5.0);
  const std::vector<float> drawn = noise.DrawByProcessor();
  EXPECT_TRUE(noise.mapper->GetErrorToleranceIsKept());
  noise.mapper->SetErrorTolerance(1.0 / 1024.0);
  const std::vector<float> traced = noise.DrawByProcessor();
  EXPECT_LT(
    CompareImages(drawn.data(), traced.data(), traced.size() / 4).percentile999, 255.0 * Tolerance);
}
