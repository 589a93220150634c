// The props that receive shadows of volumes.

#include "Module/CubeAboveFloor.h"

#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>

#include <glm/gtc/type_ptr.hpp>

TEST(ReceivingProps, AreNoPropsThatCastNoShadowsAndNoWireframes)
{
  CubeAboveFloor cube;
  cube.AddSun();
  EXPECT_TRUE(cube.ShowsShadows());
  vtkNew<vtkInformation> keys;
  keys->Set(vtkVariationFieldVolumeMapper::CASTS_SHADOWS(), 0);
  cube.floor->SetPropertyKeys(keys);
  EXPECT_FALSE(cube.ShowsShadows());
  cube.floor->SetPropertyKeys(nullptr);
  cube.floor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_FALSE(cube.ShowsShadows());
  const std::vector<float> wires = cube.FloorRed(true);
  EXPECT_GT(*std::max_element(wires.begin(), wires.end()), 0.1f) << "no wire is seen";
}

TEST(ReceivingProps, WaitForTheStillImage)
{
  CubeAboveFloor cube;
  cube.AddSun();
  cube.scene.mapper->SetMaximumImageSampleDistance(1.0);
  const std::vector<float> still = cube.FloorRed(true);
  cube.scene.window->SetDesiredUpdateRate(20.0);
  EXPECT_FALSE(cube.ShowsShadows());
  cube.scene.window->SetDesiredUpdateRate(1e-3);
  EXPECT_EQ(cube.FloorRed(true), still);
  EXPECT_TRUE(cube.ShowsShadows());
}

// A volume would dim, behind it, the colours of the volumes that were drawn before.
TEST(ReceivingProps, AreLeftOutBehindSeveralVolumes)
{
  CubeAboveFloor cube;
  cube.AddSun();
  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  mapper->SetInputData(cube.scene.image);
  mapper->ShadowsOn();
  vtkNew<vtkVolume> second;
  second->SetMapper(mapper);
  second->SetProperty(cube.scene.volume->GetProperty());
  second->SetPosition(0.0, 40.0, 0.0); // out of the view
  cube.scene.renderer->AddVolume(second);
  EXPECT_FALSE(cube.ShowsShadows());
  second->VisibilityOff();
  EXPECT_TRUE(cube.ShowsShadows());
}

TEST(ReceivingProps, AreLeftOutBehindTranslucentGeometry)
{
  CubeAboveFloor cube;
  cube.AddSun();
  const glm::dvec3 center(-7.0, 0.0, 12.0);
  const auto ball = Ball(glm::value_ptr(center), 2.0);
  ball->GetProperty()->SetOpacity(0.5);
  cube.scene.renderer->AddActor(ball);
  EXPECT_FALSE(cube.ShowsShadows());
  ball->VisibilityOff();
  EXPECT_TRUE(cube.ShowsShadows());
}
