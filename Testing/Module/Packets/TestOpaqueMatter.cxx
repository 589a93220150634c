// Opaque matter that is thinner than any step, which packets of rays meet nevertheless.

#include "Module/Scenes/MapperScene.h"

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

constexpr double OpaqueFrom = 0.999;

// Slices of one value each, seen along their axis: red from the value on at which they are opaque,
// and blue below, where they are nearly clear.
class Slices
{
public:
  explicit Slices(const std::vector<float>& values)
    : scene(ImageOf(values), 9)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(OpaqueFrom - 0.001, 0.0, 0.0, 1.0);
    this->scene.colors->AddRGBPoint(OpaqueFrom, 1.0, 0.0, 0.0);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(OpaqueFrom - 0.001, 0.0);
    this->scene.opacities->AddPoint(OpaqueFrom, 1.0);
    this->scene.LookDown({ 4.0, 4.0, 0.0 }, 2.0);
    this->scene.mapper->SetErrorTolerance(0.0);
    this->scene.mapper->AutoAdjustSampleDistancesOff();
    this->scene.mapper->SetSampleDistance(0.3);
  }

  void ExpectRed()
  {
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    ASSERT_TRUE(this->scene.ShaderParts().empty()) << "a shader has drawn it";
    const float* const middle = &drawn[4 * (9 * 4 + 4)];
    EXPECT_NEAR(middle[0], 1.0, 0.03);
    EXPECT_NEAR(middle[2], 0.0, 0.03);
    EXPECT_NEAR(middle[3], 1.0, 1e-4);
  }

  MapperScene scene;

private:
  static vtkSmartPointer<vtkImageData> ImageOf(const std::vector<float>& values)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, int(values.size()));
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* const voxels = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < 81 * int(values.size()); ++i)
    {
      voxels[i] = values[std::size_t(i / 81)];
    }
    return image;
  }
};

}

TEST(OpaqueMatter, IsMetBetweenSamples)
{
  Slices({ 0.0f, 0.0f, 0.9995f, 0.0f, 0.0f }).ExpectRed();
}

TEST(OpaqueMatter, IsMetWhereARayEntersTheVolume)
{
  Slices({ 0.0f, 0.0f, 0.0f, 0.9995f }).ExpectRed();
}

TEST(OpaqueMatter, IsMetByRaysOfAnyRule)
{
  for (const int rule :
    { vtkVariationFieldVolumeMapper::Midpoint, vtkVariationFieldVolumeMapper::PreIntegrated })
  {
    Slices slices({ 0.0f, 0.0f, 0.9995f, 0.0f, 0.0f });
    slices.scene.mapper->SetIntegrationRule(rule);
    slices.ExpectRed();
  }
}

TEST(OpaqueMatter, IsLitWhereARayMeetsIt)
{
  Slices slices({ 0.0f, 0.0f, 0.9995f, 0.0f, 0.0f });
  vtkVolumeProperty* const property = slices.scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.5);
  property->SetSpecular(0.0);
  const std::vector<float> drawn = slices.scene.DrawByProcessor();
  ASSERT_TRUE(slices.scene.ShaderParts().empty()) << "a shader has drawn it";
  EXPECT_NEAR(drawn[4 * (9 * 4 + 4)], 0.75, 0.03);
  EXPECT_NEAR(drawn[4 * (9 * 4 + 4) + 3], 1.0, 1e-4);
}

TEST(OpaqueMatter, IsPassedByRaysThatDoNotReachItsValue)
{
  Slices slices({ 0.0f, 0.0f, 0.9979f, 0.0f, 0.0f });
  const std::vector<float> drawn = slices.scene.DrawByProcessor();
  EXPECT_EQ(drawn[4 * (9 * 4 + 4) + 3], 0.0f);
}
