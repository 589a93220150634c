// Lights other than a head light, compared with closed forms for surfaces that face the eye, and
// otherwise with a reference that has the same lights.

#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr double Red = 0.8;

// A nearly opaque block whose values fall towards the eye. Its front at z = 8 fills the image.
// Ambient, diffuse and specular light are 0.1, 0.6 and 0.3, the power is 8.
class FacingBlock
{
public:
  FacingBlock()
    : scene(Values(), 17)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, Red, 0.4, 0.2);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, 0.9999);
    vtkVolumeProperty* property = this->scene.volume->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.1);
    property->SetDiffuse(0.6);
    property->SetSpecular(0.3);
    property->SetSpecularPower(8.0);
    property->SetScalarOpacityUnitDistance(0.05);
    this->scene.LookDown({ 4.0, 4.0, 0.0 }, 0.5);
    this->scene.renderer->AutomaticLightCreationOff();
    this->scene.renderer->RemoveAllLights();
  }

  vtkLight* AddLight(glm::dvec3 position, glm::dvec3 focus)
  {
    return ::AddLight(this->scene.renderer, position, focus);
  }

  double DrawnRed() { return this->scene.MiddlePixel()[0]; }

  MapperScene scene;

private:
  static vtkSmartPointer<vtkImageData> Values()
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, 9);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 9 * 9 * 9; ++i)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[i] = (unsigned char)(8 - i / 81);
    }
    return image;
  }
};

const glm::dvec3 front(4.0, 4.0, 8.0);

}

TEST(Lights, DirectionalLightFallsWithTheCosine)
{
  FacingBlock block;
  const double cosine = 0.5;
  const glm::dvec3 toLight(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  block.AddLight(front + 10.0 * toLight, front);
  const double shining = std::cos(0.5 * std::acos(cosine));
  EXPECT_NEAR(block.DrawnRed(), 0.6 * cosine * Red + 0.3 * std::pow(shining, 8.0), HalfByteStep);
}

TEST(Lights, AmbientLightIsThatOfTheLightsUnlessTheyAreHeadLights)
{
  FacingBlock block;
  vtkLight* light = block.AddLight(front + glm::dvec3(0.0, 0.0, 10.0), front);
  light->SetDiffuseColor(0.0, 0.0, 0.0);
  light->SetSpecularColor(0.0, 0.0, 0.0);
  EXPECT_NEAR(block.DrawnRed(), 0.0, HalfByteStep);
  light->SetAmbientColor(0.5, 0.0, 0.0);
  light->SetIntensity(0.5);
  EXPECT_NEAR(block.DrawnRed(), 0.1 * 0.25 * Red, HalfByteStep);
  light->SetLightTypeToHeadlight();
  EXPECT_NEAR(block.DrawnRed(), 0.1 * Red, HalfByteStep);
}

TEST(Lights, AddUpHoweverManyThereAre)
{
  FacingBlock block;
  for (int i = 0; i < 12; ++i)
  {
    vtkLight* light = block.AddLight(front + glm::dvec3(0.0, 0.0, 10.0), front);
    light->SetIntensity(0.05);
  }
  EXPECT_NEAR(block.DrawnRed(), 12 * 0.05 * (0.6 * Red + 0.3), HalfByteStep);
}

TEST(Lights, PositionalLightIsAttenuatedWithItsDistance)
{
  FacingBlock block;
  vtkLight* light = block.AddLight(front + glm::dvec3(0.0, 0.0, 4.0), front);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetAttenuationValues(0.5, 0.25, 0.125);
  EXPECT_NEAR(
    block.DrawnRed(), (0.6 * Red + 0.3) / (0.5 + 0.25 * 4.0 + 0.125 * 16.0), HalfByteStep);
}

TEST(Lights, SpotLightFallsTowardsItsConeAndIsDarkBeyond)
{
  FacingBlock block;
  // The light stands above the centre of the image and points 20 degrees to its side.
  const double beside = 5.0 * std::tan(glm::radians(20.0));
  vtkLight* light =
    block.AddLight(front + glm::dvec3(0.0, 0.0, 5.0), front + glm::dvec3(beside, 0.0, 0.0));
  light->PositionalOn();
  light->SetConeAngle(30.0);
  light->SetExponent(3.0);
  EXPECT_NEAR(block.DrawnRed(), std::pow(std::cos(glm::radians(20.0)), 3.0) * (0.6 * Red + 0.3),
    HalfByteStep);
  light->SetConeAngle(15.0);
  EXPECT_NEAR(block.DrawnRed(), 0.0, HalfByteStep);
}

TEST(Lights, TheBackOfASurfaceIsLitOnlyWhereBothSidesAre)
{
  FacingBlock block;
  block.AddLight(front - glm::dvec3(0.0, 0.0, 10.0), front);
  EXPECT_NEAR(block.DrawnRed(), 0.6 * Red, 0.005) << "no light is reflected to the eye";
  block.scene.renderer->TwoSidedLightingOff();
  EXPECT_NEAR(block.DrawnRed(), 0.0, HalfByteStep);
  // A head light still lights the front, and leaves ambient light on the back.
  FacingBlock facing;
  facing.scene.renderer->TwoSidedLightingOff();
  facing.AddLight(front, front)->SetLightTypeToHeadlight();
  EXPECT_NEAR(facing.DrawnRed(), 0.7 * Red + 0.3, HalfByteStep);
  facing.scene.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, -22.0);
  EXPECT_NEAR(facing.DrawnRed(), 0.1 * Red, HalfByteStep);
}

TEST(Lights, CameraLightsGoWithTheCamera)
{
  FacingBlock block;
  vtkLight* light = block.AddLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
  light->SetLightTypeToCameraLight();
  const double before = block.DrawnRed();
  EXPECT_NEAR(before, 0.6 * Red + 0.3, HalfByteStep);
  block.scene.renderer->GetActiveCamera()->SetPosition(4.0, 4.0, -22.0);
  EXPECT_NEAR(block.DrawnRed(), before, HalfByteStep);
}

TEST(Lights, OnStretchedShearedAndTurnedVolumesAreThoseOfTheReference)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  MapperScene scene(torso, 48);
  scene.volume->SetScale(1.4, 0.7, 1.0);
  scene.volume->RotateWXYZ(35.0, 0.3, 1.0, 0.2);
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->SetSpecularPower(5.0);
  scene.renderer->ResetCamera();
  UseSunAndLamp(scene.renderer);

  const ImageError error = scene.ErrorOf(MaterialInLights(scene));
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 10.0);
}

TEST(Lights, TakeTheirShaderOnlyWhereTheyAre)
{
  MapperScene scene(SmallTorso(), 16);
  scene.volume->GetProperty()->ShadeOn();
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Shade/HeadLight.glsl"));
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  vtkNew<vtkLight> sun;
  scene.renderer->AddLight(sun);
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Shade/Lights.glsl"));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes + 5 * 16);
  scene.volume->GetProperty()->ShadeOff();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
}

TEST(TransferFunctions, OfOneChannelAreGray)
{
  MapperScene scene(SmallTorso(), 32);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(-200.0, 0.1, 0.1, 0.1);
  scene.colors->AddRGBPoint(400.0, 0.9, 0.9, 0.9);
  const std::vector<float> expected = scene.Draw();
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(-200.0, 0.1);
  gray->AddPoint(400.0, 0.9);
  scene.volume->GetProperty()->SetColor(gray);
  EXPECT_LT(CompareImages(scene.Draw().data(), expected.data(), 32 * 32).largest, 1e-3);
  gray->AddPoint(400.0, 0.5);
  EXPECT_GT(CompareImages(scene.Draw().data(), expected.data(), 32 * 32).largest, 10.0);
}
