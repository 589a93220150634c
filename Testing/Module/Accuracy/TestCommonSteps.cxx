// Steps that several mappers share, each of which draws a part of one volume.

#include "Module/Scenes/MapperScene.h"
#include "Tolerance/SharedSearch.h"

#include <vtkCamera.h>
#include <vtkLight.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

using varimarch::CommonSteps;
using varimarch::SearchingProcesses;
using varimarch::SharedSearch;

namespace
{

constexpr double Tolerance = 1.0 / 64.0;

/// A scene with two more mappers, each of which draws a half of the volume along x.
struct Halves
{
  explicit Halves(MapperScene& scene)
    : scene(scene)
  {
    double bounds[6];
    scene.Draw(); // opens the window
    scene.mapper->GetBounds(bounds);
    const double middle = 0.5 * (bounds[0] + bounds[1]);
    for (int half = 0; half < 2; ++half)
    {
      std::array<double, 6> box;
      std::copy_n(bounds, 6, box.begin());
      box[1 - half] = middle;
      this->mappers[half]->SetInputDataObject(scene.mapper->GetInputDataObject(0, 0));
      this->mappers[half]->SetProcessorMarching(scene.mapper->GetProcessorMarching());
      this->mappers[half]->SetErrorTolerance(Tolerance);
      this->mappers[half]->CroppingOn();
      this->mappers[half]->SetCroppingRegionPlanes(box.data());
    }
  }

  /// Searches with the half at the larger x in front.
  std::optional<CommonSteps> FindSteps(const SearchingProcesses& processes)
  {
    return this->search.Find(
      this->scene.renderer, this->scene.volume, { this->mappers[1], this->mappers[0] }, processes);
  }

  MapperScene& scene;
  vtkNew<vtkVariationFieldVolumeMapper> mappers[2];
  SharedSearch search;
};

std::optional<CommonSteps> FindSteps(MapperScene& scene, SharedSearch& search)
{
  return search.Find(scene.renderer, scene.volume, { scene.mapper }, SearchingProcesses::Single());
}

void LookAlongX(MapperScene& scene)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetFocalPoint(scene.volume->GetCenter());
  camera->SetPosition(
    camera->GetFocalPoint()[0] + 200.0, camera->GetFocalPoint()[1], camera->GetFocalPoint()[2]);
  scene.renderer->ResetCamera();
}

}

TEST(CommonSteps, ReplaceTheSearchUntilThereIsNoTolerance)
{
  MapperScene scene(SmallTorso());
  SharedSearch search;
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.Draw();
  const int searches = scene.mapper->GetToleranceSearches();
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  const std::optional<CommonSteps> found = FindSteps(scene, search);
  ASSERT_TRUE(found);
  scene.Draw();
  EXPECT_DOUBLE_EQ(scene.mapper->GetUsedSampleDistance(), found->step.sampleDistance);
  EXPECT_EQ(scene.mapper->GetEstimatedError(), found->step.error);
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches);
  scene.mapper->SetErrorTolerance(0.0);
  EXPECT_FALSE(FindSteps(scene, search));
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches + 1);
}

TEST(CommonSteps, AreAtMostTheStepsOfTheMapperAlone)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.Draw();
  const double alone = scene.mapper->GetUsedSampleDistance();
  SharedSearch search;
  const std::optional<CommonSteps> found = FindSteps(scene, search);
  ASSERT_TRUE(found);
  EXPECT_LE(found->step.sampleDistance, alone);
  EXPECT_GT(found->step.sampleDistance, 0.8 * alone);
}

TEST(CommonSteps, AreThoseOfTheWholeHoweverItIsDivided)
{
  for (const double tolerance : { Tolerance, 1.0 / 256.0 })
  {
    MapperScene scene(SmallTorso());
    LookAlongX(scene);
    scene.mapper->SetErrorTolerance(tolerance);
    Halves halves(scene);
    SharedSearch search;
    const std::optional<CommonSteps> whole = FindSteps(scene, search);
    halves.mappers[0]->SetErrorTolerance(tolerance);
    halves.mappers[1]->SetErrorTolerance(tolerance);
    const std::optional<CommonSteps> found = halves.FindSteps(SearchingProcesses::Single());
    ASSERT_TRUE(whole && found);
    EXPECT_DOUBLE_EQ(found->step.sampleDistance, whole->step.sampleDistance) << tolerance;
    EXPECT_EQ(found->isPreIntegrated, whole->isPreIntegrated) << tolerance;
  }
}

TEST(CommonSteps, AreSearchedOnceForAnImage)
{
  MapperScene scene(SmallTorso());
  Halves halves(scene);
  ASSERT_TRUE(halves.FindSteps(SearchingProcesses::Single()));
  ASSERT_TRUE(halves.FindSteps(SearchingProcesses::Single()));
  EXPECT_EQ(halves.search.Searches(), 1);
  scene.renderer->GetActiveCamera()->Azimuth(1.0);
  ASSERT_TRUE(halves.FindSteps(SearchingProcesses::Single()));
  EXPECT_EQ(halves.search.Searches(), 2);
}

// A process that has no part takes those of others, whose numbers are smaller.
TEST(CommonSteps, AreThoseOfTheLeaderOnAProcessWithoutParts)
{
  MapperScene scene(SmallTorso());
  SharedSearch search;
  const std::vector<double> end = { 0.0, 0.5, 0.01, 0.9, 1.0, 1.0, 0.0 };
  const std::vector<double> trial = { 1.0, 0.0, 0.25, 1.0, 0.0, 1.0, 0.25 };
  int messages = 0;
  int images = 0;
  SearchingProcesses processes;
  processes.isLeader = false;
  processes.takeLeast = [](std::vector<double>& numbers)
  {
    EXPECT_GT(numbers.front(), 1e9) << "there is no part";
    // The facts end with two conditions, which the coarsest distance of the whole has not.
    std::fill(numbers.begin(), numbers.end() - (numbers.size() > 1 ? 2 : 0), 0.5);
  };
  processes.takeFromLeader = [&](std::vector<double>& numbers)
  { numbers = ++messages > 2 ? end : trial; };
  processes.layOver = [&](std::vector<float> own)
  {
    EXPECT_TRUE(own.empty());
    ++images;
    return own;
  };
  const auto found = search.Find(scene.renderer, scene.volume, {}, processes);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step.sampleDistance, 0.5);
  EXPECT_TRUE(found->isPreIntegrated);
  EXPECT_EQ(images, 2);
}

TEST(CommonSteps, AreNoneIfAnotherProcessRefusesThem)
{
  MapperScene scene(SmallTorso());
  Halves halves(scene);
  SearchingProcesses processes = SearchingProcesses::Single();
  processes.takeLeast = [](std::vector<double>& numbers) { *(numbers.end() - 2) = -1.0; };
  EXPECT_FALSE(halves.FindSteps(processes));
  EXPECT_EQ(halves.search.Searches(), 0);
}

TEST(CommonSteps, AreOfImagesLaidOverEachOther)
{
  const std::vector<float> front = { 0.25F, 0.0F, 0.5F, 0.5F, 0.0F, 0.0F, 0.0F, 0.0F };
  const std::vector<float> behind = { 0.5F, 0.5F, 0.0F, 0.5F, 0.25F, 0.5F, 0.75F, 1.0F };
  const std::vector<float> whole = { 0.5F, 0.25F, 0.5F, 0.75F, 0.25F, 0.5F, 0.75F, 1.0F };
  EXPECT_EQ(varimarch::LaidOver(front, behind), whole);
  EXPECT_EQ(varimarch::LaidOver({}, behind), behind);
  EXPECT_EQ(varimarch::LaidOver(front, {}), front);
}

// VTK moves such lights only while it draws.
TEST(CommonSteps, AreFoundInTheLightThatFollowsTheCamera)
{
  MapperScene scene(SmallTorso());
  SharedSearch search;
  scene.volume->GetProperty()->ShadeOn();
  scene.renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(1.0, 0.5, 1.0);
  scene.renderer->AddLight(light);
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.Draw();
  scene.renderer->GetActiveCamera()->Azimuth(70.0);
  ASSERT_TRUE(FindSteps(scene, search));
  scene.Draw();
  ASSERT_TRUE(FindSteps(scene, search));
  EXPECT_EQ(search.Searches(), 1) << "the light is another";
}
