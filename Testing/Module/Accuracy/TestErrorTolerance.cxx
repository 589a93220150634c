// The mapper keeps its error tolerance, judged by the reference integrator.

#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

struct ToleranceCase
{
  std::string name;
  std::function<void(MapperScene&)> prepare;
};

void SetOpacities(MapperScene& scene, const std::vector<std::array<double, 2>>& nodes)
{
  scene.opacities->RemoveAllPoints();
  for (const auto& [value, opacity] : nodes)
  {
    scene.opacities->AddPoint(value, opacity);
  }
}

const std::vector<ToleranceCase> Cases = {
  { "VeilAndBone", [](MapperScene&) {} },
  { "Shaded", [](MapperScene& scene) { scene.volume->GetProperty()->ShadeOn(); } },
  { "ThinPeak",
    [](MapperScene& scene) {
      SetOpacities(scene, { { 100.0, 0.0 }, { 110.0, 0.2 }, { 120.0, 0.0 } });
    } },
  { "Dense",
    [](MapperScene& scene) {
      SetOpacities(scene, { { 0.0, 0.0 }, { 150.0, 0.2 }, { 300.0, 0.9 } });
    } },
  { "Haze",
    [](MapperScene& scene) {
      SetOpacities(scene, { { -1000.0, 0.0 }, { 1000.0, 0.002 } });
    } },
  { "Additive",
    [](MapperScene& scene)
    {
      scene.mapper->SetBlendModeToAdditive();
      SetOpacities(scene, { { -1000.0, 0.0 }, { 1000.0, 0.02 } });
    } },
  { "AverageIntensity",
    [](MapperScene& scene)
    {
      scene.mapper->SetBlendModeToAverageIntensity();
      SetOpacities(scene, { { -100.0, 0.0 }, { 100.0, 1.0 } });
    } },
};

// Sheets that lie between the samples of a ray along z, for sample distances of two and of four
// voxels.
vtkSmartPointer<vtkImageData> SheetsEveryFourVoxels()
{
  constexpr int Side = 41;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < Side * Side * Side; ++i)
  {
    voxels[i] = i / (Side * Side) % 4 == 0 ? 100 : 0;
  }
  return image;
}

}

class ErrorTolerance : public testing::TestWithParam<ToleranceCase>
{
};

TEST_P(ErrorTolerance, IsKept)
{
  MapperScene scene(SmallTorso());
  scene.mapper->AutoAdjustSampleDistancesOn();
  GetParam().prepare(scene);
  const std::vector<float> truth = scene.Truth();
  double coarser = 1e30;
  for (double tolerance : { 1.0 / 32.0, 1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0 })
  {
    scene.mapper->SetErrorTolerance(tolerance);
    const std::vector<float> drawn = scene.Draw();
    const varimarch::ImageError error =
      varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LE(error.percentile999, 255.0 * tolerance) << tolerance;
    EXPECT_LE(error.largest, 2.0 * 255.0 * tolerance) << tolerance;
    EXPECT_LT(scene.mapper->GetUsedSampleDistance(), coarser) << tolerance;
    EXPECT_GT(scene.mapper->GetEstimatedError(), 0.0);
    EXPECT_LT(scene.mapper->GetEstimatedError(), tolerance);
    coarser = scene.mapper->GetUsedSampleDistance();
  }
}

TEST_P(ErrorTolerance, IsKeptWhileTheViewMoves)
{
  constexpr double Tolerance = 1.0 / 64.0;
  MapperScene scene(SmallTorso());
  scene.mapper->AutoAdjustSampleDistancesOn();
  GetParam().prepare(scene);
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.Draw();
  for (int picture = 0; picture < 2; ++picture)
  {
    scene.renderer->GetActiveCamera()->Azimuth(2.0);
    const std::vector<float> drawn = scene.Draw();
    const std::vector<float> truth = scene.Truth();
    const varimarch::ImageError error =
      varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LE(error.percentile999, 255.0 * Tolerance);
    EXPECT_LE(error.largest, 2.0 * 255.0 * Tolerance);
  }
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 1);
}

INSTANTIATE_TEST_SUITE_P(Of, ErrorTolerance, testing::ValuesIn(Cases),
  [](const testing::TestParamInfo<ToleranceCase>& info) { return info.param.name; });

TEST(ErrorTolerance, IsTriedOutAgainOnlyWhenThePictureChanges)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 1);
  scene.renderer->GetActiveCamera()->Azimuth(30.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 2);
  scene.opacities->AddPoint(300.0, 0.1);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 3);
  scene.mapper->SetErrorTolerance(1.0 / 32.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 4);
  auto* const light = vtkLight::SafeDownCast(scene.renderer->GetLights()->GetItemAsObject(0));
  light->SetIntensity(0.7);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 4) << "nothing is lit";
  scene.volume->GetProperty()->ShadeOn();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 5);
  light->SetIntensity(0.5);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 6);
}

TEST(ErrorTolerance, OneSearchServesViewsNearbyUntilTheViewRests)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  const double searchedDistance = scene.mapper->GetUsedSampleDistance();
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  const auto searchesAfter = [&](const std::function<void()>& move)
  {
    move();
    scene.renderer->ResetCameraClippingRange();
    scene.Draw();
    return scene.mapper->GetToleranceSearches();
  };
  EXPECT_EQ(searchesAfter([&] { camera->Azimuth(1.0); }), 1);
  EXPECT_GE(scene.mapper->GetUsedSampleDistance(), 0.85 * searchedDistance);
  EXPECT_EQ(searchesAfter([&] { camera->Azimuth(-1.0); }), 1);
  EXPECT_EQ(scene.mapper->GetUsedSampleDistance(), searchedDistance);
  EXPECT_EQ(searchesAfter([&] { camera->Zoom(1.02); }), 1);
  EXPECT_EQ(searchesAfter([] {}), 2) << "a view that rests";
  EXPECT_EQ(searchesAfter([&] { camera->Zoom(1.8); }), 3);
  EXPECT_EQ(searchesAfter([&] { camera->Dolly(10.0); }), 4) << "into the volume";
  EXPECT_EQ(searchesAfter([&] { camera->Azimuth(1.0); }), 5) << "within the volume";
}

namespace
{

std::string DrawnMarch(MapperScene& scene)
{
  scene.Draw();
  const std::vector<std::string> parts = scene.ShaderParts();
  return *std::find_if(parts.begin(), parts.end(),
    [](const std::string& part) { return part.rfind("March/", 0) == 0; });
}

}

TEST(ErrorTolerance, ChoosesPreIntegrationForThinPeaksOnly)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  EXPECT_EQ(DrawnMarch(scene), "March/Midpoint.glsl");
  SetOpacities(scene, { { 300.0, 0.0 }, { 308.0, 0.5 }, { 316.0, 0.0 } });
  EXPECT_EQ(DrawnMarch(scene), "March/PreIntegrated.glsl");
}

// Midpoints for noise that is visible everywhere; linear interpolation between samples for thin
// shells.
TEST(ErrorTolerance, ChoosesTheRuleOfLitPicturesToo)
{
  const auto marchOf =
    [](std::array<int, 3> size, const std::vector<std::array<double, 2>>& opacities)
  {
    MapperScene scene(varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, size, 7 }));
    SetOpacities(scene, opacities);
    scene.volume->GetProperty()->ShadeOn();
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
    return DrawnMarch(scene);
  };
  EXPECT_EQ(marchOf({ 64, 64, 64 }, { { 200.0, 0.0 }, { 250.0, 0.5 }, { 300.0, 0.0 } }),
    "March/MaterialSegments.glsl");
  EXPECT_EQ(
    marchOf({ 40, 36, 24 }, { { -1024.0, 0.0 }, { 400.0, 0.5 } }), "March/MaterialMidpoint.glsl");
}

namespace
{

// A lit shell, rendered by packets of rays.
class LitShell
{
public:
  LitShell(double opacityUnitMm, double tolerance)
    : scene(varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 64, 64 }, 7 }))
  {
    SetOpacities(this->scene, { { 225.0, 0.0 }, { 250.0, 0.5 }, { 275.0, 0.0 } });
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.volume->GetProperty()->SetScalarOpacityUnitDistance(opacityUnitMm);
    this->scene.mapper->SetErrorTolerance(tolerance);
    this->scene.mapper->ProcessorMarchingOn();
  }

  std::vector<float> DrawBy(int rule)
  {
    this->scene.mapper->SetIntegrationRule(rule);
    return this->scene.Draw();
  }

  double EstimateBy(int rule)
  {
    this->DrawBy(rule);
    return this->scene.mapper->GetEstimatedError();
  }

private:
  MapperScene scene;
};

}

TEST(ErrorTolerance, LitPacketsUseMidpointsIfTheyKeepIt)
{
  LitShell shell(1.0, 1.0 / 64.0);
  EXPECT_EQ(shell.DrawBy(Mapper::Automatic), shell.DrawBy(Mapper::Midpoint));
}

TEST(ErrorTolerance, LitPacketsOtherwiseUseTheRuleThatIsCloser)
{
  const ExpectedVtkErrors warnings; // the tolerance cannot be kept
  LitShell shell(0.5, 1e-4);
  const double linear = shell.EstimateBy(Mapper::PreIntegrated);
  EXPECT_GT(shell.EstimateBy(Mapper::Midpoint), 1.5 * linear);
  EXPECT_EQ(shell.EstimateBy(Mapper::Automatic), linear);
}

TEST(ErrorTolerance, DrawsNothingIntoTheWindowWhenTriedOut)
{
  // A probe that left its viewport, framebuffer or clear colour behind would change the image.
  MapperScene scene(SmallTorso());
  scene.renderer->SetBackground(0.2, 0.4, 0.6);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const std::vector<float> tried = scene.Draw();
  EXPECT_EQ(tried, scene.Draw());
}

TEST(ErrorTolerance, IsThatOfColoursInTheWindow)
{
  using Way = std::vector<float> (MapperScene::*)();
  for (const Way draw : std::vector<Way>{ &MapperScene::Draw, &MapperScene::DrawByProcessor })
  {
    MapperScene scene(SmallTorso());
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
    (scene.*draw)();
    const double distance = scene.mapper->GetUsedSampleDistance();
    scene.mapper->SetFinalColorWindow(0.9f);
    (scene.*draw)();
    scene.mapper->SetFinalColorWindow(0.2f); // multiplies errors by five
    (scene.*draw)();
    EXPECT_LT(scene.mapper->GetUsedSampleDistance(), 0.8 * distance);
  }
}

TEST(ErrorTolerance, PacketsSearchWithoutAFramebuffer)
{
  MapperScene scene(SmallTorso());
  const auto bytesOf = [&](std::vector<float> (MapperScene::*draw)(), double tolerance)
  {
    scene.mapper->SetErrorTolerance(tolerance);
    (scene.*draw)();
    return scene.mapper->GetGraphicsMemoryBytes();
  };
  constexpr int BytesOfProbe = 96 * 48 * 16;
  EXPECT_EQ(
    bytesOf(&MapperScene::Draw, 1.0 / 64.0), bytesOf(&MapperScene::Draw, 0.0) + BytesOfProbe);
  EXPECT_EQ(bytesOf(&MapperScene::DrawByProcessor, 1.0 / 64.0),
    bytesOf(&MapperScene::DrawByProcessor, 0.0));
}

TEST(ErrorTolerance, IsTriedOutByColoursWhileFetchCountsAreDrawn)
{
  MapperScene counting(SmallTorso());
  counting.mapper->DrawFetchCountsOn();
  MapperScene colored(SmallTorso());
  for (MapperScene* scene : { &counting, &colored })
  {
    scene->mapper->SetErrorTolerance(1.0 / 64.0);
    scene->Draw();
  }
  EXPECT_EQ(counting.mapper->GetUsedSampleDistance(), colored.mapper->GetUsedSampleDistance());
  EXPECT_EQ(counting.mapper->GetEstimatedError(), colored.mapper->GetEstimatedError());
}

TEST(ErrorTolerance, DoesNotDependOnTheOnesBefore)
{
  MapperScene scene(SheetsEveryFourVoxels());
  SetOpacities(scene, { { 0.0, 0.0 }, { 100.0, 0.03 } });
  scene.mapper->SetAccelerationModeToOff();
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(camera->GetFocalPoint()[0], camera->GetFocalPoint()[1], 200.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  const auto distanceFor = [&](double tolerance)
  {
    scene.mapper->SetErrorTolerance(tolerance);
    scene.Draw();
    return scene.mapper->GetUsedSampleDistance();
  };
  const double alone = distanceFor(1.0 / 64.0);
  const double coarse = distanceFor(1.0);
  EXPECT_GT(coarse, alone);
  // A search that starts at four voxels would see nothing there and at two voxels, and trust it.
  EXPECT_EQ(distanceFor(1.0 / 64.0), alone);
}
