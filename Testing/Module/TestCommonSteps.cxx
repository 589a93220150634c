// Steps that several mappers share, each of which draws a part of one volume.

#include "Module/MapperScene.h"

#include <vtkCamera.h>
#include <vtkLight.h>

#include <gtest/gtest.h>

TEST(CommonSteps, ReplaceTheSearchUntilTheyAreTakenBack)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  const double found = scene.mapper->GetUsedSampleDistance();
  const int searches = scene.mapper->GetToleranceSearches();
  scene.mapper->SetCommonSteps(0.4 * found, false);
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Draw();
  EXPECT_DOUBLE_EQ(scene.mapper->GetUsedSampleDistance(), 0.4 * found);
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches);
  scene.mapper->SetCommonSteps(0.0, false);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches + 1);
}

TEST(CommonSteps, AreFoundAsForTheImageThatFollows)
{
  MapperScene scene(SmallTorso());
  double distance = 0.0;
  bool preIntegration = true;
  scene.Draw();
  EXPECT_FALSE(scene.mapper->FindSteps(scene.renderer, scene.volume, distance, preIntegration));
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetCommonSteps(0.01, true); // steps of an earlier image do not matter
  ASSERT_TRUE(scene.mapper->FindSteps(scene.renderer, scene.volume, distance, preIntegration));
  scene.mapper->SetCommonSteps(0.0, false);
  scene.Draw();
  EXPECT_DOUBLE_EQ(scene.mapper->GetUsedSampleDistance(), distance);
  EXPECT_FALSE(preIntegration);
}

// VTK moves such lights only while it draws.
TEST(CommonSteps, AreFoundInTheLightThatFollowsTheCamera)
{
  MapperScene scene(SmallTorso());
  scene.volume->GetProperty()->ShadeOn();
  scene.renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(1.0, 0.5, 1.0);
  scene.renderer->AddLight(light);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.Draw();
  scene.renderer->GetActiveCamera()->Azimuth(70.0);
  double distance = 0.0;
  bool preIntegration = false;
  ASSERT_TRUE(scene.mapper->FindSteps(scene.renderer, scene.volume, distance, preIntegration));
  const int searches = scene.mapper->GetToleranceSearches();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), searches) << "the light is another";
  EXPECT_EQ(scene.mapper->GetUsedSampleDistance(), distance);
}
