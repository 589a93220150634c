// Volumes of two to four components: closed forms of homogeneous mixtures, comparison with the
// reference, and the precision of every scalar type.

#include "Module/Scenes/ComponentVolumes.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// One value in each component, except on a face, so that they have a range.
vtkSmartPointer<vtkImageData> ConstantBut(int components)
{
  return ImageOf(VTK_UNSIGNED_CHAR, components,
    [](glm::ivec3 voxel, int component) { return voxel.x == 0 ? 0.0 : 60.0 + 10.0 * component; });
}

}

class IndependentComponents : public testing::TestWithParam<int>
{
};

TEST_P(IndependentComponents, AreAMixtureByTheirWeights)
{
  const int count = GetParam();
  MapperScene scene(
    ImageOf(VTK_UNSIGNED_CHAR, count,
      [](glm::ivec3 voxel, int component) { return voxel.x == 0 ? 0.0 : 60.0 + 10.0 * component; }),
    9);
  LookAlongZ(scene);
  vtkVolumeProperty* property = scene.volume->GetProperty();
  glm::dvec3 emission(0.0);
  double extinction = 0.0;
  for (int component = 0; component < count; ++component)
  {
    SetLook(property, component, looks[component]);
    property->SetScalarOpacityUnitDistance(component, 1.0 + component);
    property->SetComponentWeight(component, 1.0 - 0.2 * component);
    const double opacity = OpacityOf(looks[component], 60.0 + 10.0 * component);
    const double absorbed = (1.0 - 0.2 * component) * -std::log1p(-opacity) / (1.0 + component);
    extinction += absorbed;
    emission += absorbed * looks[component].color;
  }
  const double alpha = -std::expm1(-extinction * 6.0);
  const std::array<float, 4> drawn = scene.MiddlePixel();
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(drawn[channel], alpha * emission[channel] / extinction, HalfByteStep) << channel;
  }
  EXPECT_NEAR(drawn[3], alpha, HalfByteStep);
}

// VTK's functions for components without any are opaque, so that the volume would be a black box.
TEST_P(IndependentComponents, WithoutFunctionsHaveThoseOfTheFirst)
{
  const int count = GetParam();
  MapperScene given(ConstantBut(count), 9);
  MapperScene missing(ConstantBut(count), 9);
  for (MapperScene* const scene : { &given, &missing })
  {
    LookAlongZ(*scene);
    vtkVolumeProperty* const property = scene->volume->GetProperty();
    for (int component = 0; component < (scene == &given ? count : 1); ++component)
    {
      SetLook(property, component, looks[0]);
      property->SetScalarOpacityUnitDistance(component, 3.0);
    }
  }
  EXPECT_EQ(given.MiddlePixel(), missing.MiddlePixel());
  EXPECT_LT(missing.MiddlePixel()[3], 0.99f);

  // A colour without opacities is kept.
  vtkNew<vtkColorTransferFunction> red;
  red->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  for (MapperScene* const scene : { &given, &missing })
  {
    scene->volume->GetProperty()->SetColor(1, red);
  }
  EXPECT_EQ(given.MiddlePixel(), missing.MiddlePixel());
}

TEST_P(IndependentComponents, AddWhatEachIsOverAUnitDistanceInAnExtreme)
{
  const int count = GetParam();
  MapperScene scene(ConstantBut(count), 9);
  LookAlongZ(scene);
  glm::dvec4 sum(0.0);
  for (int component = 0; component < count; ++component)
  {
    SetLook(scene.volume->GetProperty(), component, looks[component]);
    scene.volume->GetProperty()->SetComponentWeight(component, 1.0 - 0.2 * component);
    const double opacity = OpacityOf(looks[component], 60.0 + 10.0 * component);
    sum += (1.0 - 0.2 * component) * opacity * glm::dvec4(looks[component].color, 1.0);
  }
  for (int blend :
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND })
  {
    scene.mapper->SetBlendMode(blend);
    EXPECT_NEAR(scene.MiddlePixel()[3], sum.a, HalfByteStep);
    EXPECT_NEAR(scene.MiddlePixel()[1], sum.g, HalfByteStep);
  }
}

INSTANTIATE_TEST_SUITE_P(TwoToFour, IndependentComponents, testing::Values(2, 3, 4));

TEST(Components, AverageAndAdditiveAreWeightedSums)
{
  // Values rise linearly along the ray, those of the second component twice as steeply.
  MapperScene scene(
    ImageOf(VTK_FLOAT, 2,
      [](glm::ivec3 voxel, int component) { return voxel.z * (component + 1) * 10.0; }),
    9);
  LookAlongZ(scene);
  vtkVolumeProperty* property = scene.volume->GetProperty();
  for (int component = 0; component < 2; ++component)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.1 * (component + 1));
    property->SetScalarOpacity(component, opacity);
  }
  property->SetComponentWeight(1, 0.5);
  property->SetScalarOpacityUnitDistance(1, 2.0);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.05);
  // Grey rises from 0 to 1 along the ray, so its mean is a half.
  scene.mapper->SetBlendModeToAverageIntensity();
  EXPECT_NEAR(scene.MiddlePixel()[0], 0.1 * 0.5 + 0.5 * 0.2 * 0.5, HalfByteStep);
  scene.mapper->SetBlendModeToAdditive();
  EXPECT_NEAR(scene.MiddlePixel()[0], 6.0 * 0.1 * 0.5 + 0.5 * 0.2 * 0.5 * 6.0 / 2.0, HalfByteStep);
  // The range covers all of the first component's values and half of the second's.
  scene.mapper->SetBlendModeToAverageIntensity();
  scene.mapper->SetAverageIPScalarRange(-1.0, 60.0);
  EXPECT_NEAR(scene.MiddlePixel()[0], 0.1 * 0.5 + 0.5 * 0.2 * 0.25, 2.0 * HalfByteStep);
}

TEST(Components, MinimumIsASmallestValue)
{
  MapperScene scene(
    ImageOf(VTK_UNSIGNED_CHAR, 2, [](glm::ivec3 voxel, int) { return voxel.z == 3 ? 0.0 : 200.0; }),
    9);
  LookAlongZ(scene);
  for (int component = 0; component < 2; ++component)
  {
    SetLook(scene.volume->GetProperty(), component, { glm::dvec3(1.0), 0.0, 200.0, 0.9 });
  }
  scene.mapper->SetBlendModeToMinimumIntensity();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.02);
  EXPECT_LT(scene.MiddlePixel()[3], 0.05);
}

TEST(Components, MaximaOfSeveralAddTheirLight)
{
  MapperScene scene(
    ImageOf(VTK_UNSIGNED_CHAR, 2,
      [](glm::ivec3 voxel, int component) { return voxel.z == 2 + 2 * component ? 200.0 : 0.0; }),
    9);
  LookAlongZ(scene);
  SetLook(scene.volume->GetProperty(), 0, { glm::dvec3(1.0, 0.0, 0.0), 0.0, 200.0, 0.3 });
  SetLook(scene.volume->GetProperty(), 1, { glm::dvec3(0.0, 1.0, 0.0), 0.0, 200.0, 0.4 });
  scene.volume->GetProperty()->SetComponentWeight(1, 0.5);
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.002);
  const std::array<float, 4> drawn = scene.MiddlePixel();
  EXPECT_NEAR(drawn[0], 0.3, HalfByteStep);
  EXPECT_NEAR(drawn[1], 0.5 * 0.4, HalfByteStep);
  EXPECT_NEAR(drawn[3], 0.3 + 0.5 * 0.4, HalfByteStep);
}

TEST(Components, OfEveryTypeKeepTheirPrecision)
{
  // Steps of 1 in a range of 20000 would be lost in texels of 8 bits.
  for (const int type : { VTK_UNSIGNED_SHORT, VTK_SHORT, VTK_INT, VTK_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    MapperScene scene(ImageOf(type, 2,
                        [](glm::ivec3 voxel, int component)
                        { return voxel.x == 0 ? 20000.0 * (voxel.y % 2) : 10000.0 + component; }),
      9);
    LookAlongZ(scene);
    SetLook(scene.volume->GetProperty(), 0, { glm::dvec3(1.0), 9998.0, 10002.0, 0.2 });
    SetLook(scene.volume->GetProperty(), 1, { glm::dvec3(1.0), 9999.0, 10002.0, 0.3 });
    const double expected = 1.0 - std::pow(1.0 - 0.1, 6.0) * std::pow(1.0 - 0.2, 6.0);
    EXPECT_NEAR(scene.MiddlePixel()[3], expected, HalfByteStep)
      << scene.image->GetScalarTypeAsString();
  }
}

TEST(Components, TwoDependentComponentsAreColourAndOpacity)
{
  MapperScene scene(ImageOf(VTK_DOUBLE, 2,
                      [](glm::ivec3 voxel, int component) {
                        return voxel.x == 0 ? 0.0 : component == 0 ? 30.0 : 80.0;
                      }),
    9);
  LookAlongZ(scene);
  vtkVolumeProperty* property = scene.volume->GetProperty();
  property->IndependentComponentsOff();
  SetLook(property, 0, { glm::dvec3(1.0), 60.0, 100.0, 0.2 });
  property->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(40.0, 0.8, 0.0, 0.0);
  const double alpha = 1.0 - std::pow(1.0 - 0.1, 6.0);
  const std::array<float, 4> drawn = scene.MiddlePixel();
  EXPECT_NEAR(drawn[0], 0.6 * alpha, HalfByteStep);
  EXPECT_NEAR(drawn[1], 0.25 * alpha, HalfByteStep);
  EXPECT_NEAR(drawn[3], alpha, HalfByteStep);
  scene.mapper->SetBlendModeToMaximumIntensity();
  EXPECT_NEAR(scene.MiddlePixel()[0], 0.6 * 0.1, HalfByteStep);
}

TEST(Components, GradientOpacityOfDependentComponentsUsesTheOpacityComponent)
{
  // Only the second component has a gradient.
  MapperScene scene(
    ImageOf(VTK_DOUBLE, 2,
      [](glm::ivec3 voxel, int component) { return component == 0 ? 30.0 : 40.0 + 4.0 * voxel.z; }),
    9);
  LookAlongZ(scene);
  vtkVolumeProperty* property = scene.volume->GetProperty();
  property->IndependentComponentsOff();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(100.0, 0.1);
  property->SetScalarOpacity(opacity);
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.2);
  factors->AddPoint(1.0, 1.0);
  property->SetGradientOpacity(factors);
  EXPECT_NEAR(scene.MiddlePixel()[3], 1.0 - std::pow(1.0 - 0.1, 6.0), HalfByteStep);
}

TEST(Components, FourDependentComponentsAreAColourAndOpacity)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    const double one = type == VTK_FLOAT ? 1.0 : 255.0;
    const double rgba[] = { 0.8 * one, 0.4 * one, 0.2 * one, 0.6 * one };
    MapperScene scene(ImageOf(type, 4,
                        [&](glm::ivec3 voxel, int component)
                        { return voxel.x == 0 ? 0.1 * one : rgba[component]; }),
      9);
    LookAlongZ(scene);
    vtkVolumeProperty* property = scene.volume->GetProperty();
    property->IndependentComponentsOff();
    SetLook(property, 0, { glm::dvec3(0.0), 0.5 * one, 0.7 * one, 0.2 });
    const double alpha = 1.0 - std::pow(1.0 - 0.1, 6.0);
    const std::array<float, 4> drawn = scene.MiddlePixel();
    EXPECT_NEAR(drawn[0], 0.8 * alpha, HalfByteStep);
    EXPECT_NEAR(drawn[1], 0.4 * alpha, HalfByteStep);
    EXPECT_NEAR(drawn[2], 0.2 * alpha, HalfByteStep);
    EXPECT_NEAR(drawn[3], alpha, HalfByteStep);
  }
}

TEST(Components, ThreeDependentComponentsAreAnError)
{
  MapperScene scene(ImageOf(VTK_FLOAT, 3, [](glm::ivec3, int) { return 1.0; }), 9);
  scene.volume->GetProperty()->IndependentComponentsOff();
  ExpectedVtkErrors errors;
  scene.window->Render();
  EXPECT_NE(errors.Text().find("3 components that depend on each other"), std::string::npos);
}

TEST(Components, InBlocksAreTheSamePicture)
{
  const auto doubled = [](glm::ivec3 voxel, int component)
  { return BallValue(voxel / 3, component); };
  MapperScene scene(ImageOf(VTK_SHORT, 2, doubled, { 48, 48, 48 }), 33);
  for (int component = 0; component < 2; ++component)
  {
    SetLook(scene.volume->GetProperty(), component, looks[component]);
  }
  for (const int blend : { vtkVolumeMapper::COMPOSITE_BLEND,
         vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    scene.mapper->SetBlendMode(blend);
    scene.mapper->SetMaximumGraphicsMemory(0);
    const std::vector<float> whole = scene.Draw();
    scene.mapper->SetMaximumGraphicsMemory(170000); // less than the voxels take in 8 bits
    const std::vector<float> inBlocks = scene.Draw();
    EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
    EXPECT_LT(CompareImages(inBlocks.data(), whole.data(), 33 * 33).largest, 2.0) << blend;
  }
}

TEST(Components, AVoxelThatIsNotFiniteInOneIsAGapInAll)
{
  const auto image = ImageOf(VTK_FLOAT, 2, BallValue, { 17, 17, 17 });
  image->SetScalarComponentFromDouble(8, 8, 8, 1, std::nan(""));
  MapperScene scene(image, 33);
  for (int component = 0; component < 2; ++component)
  {
    SetLook(scene.volume->GetProperty(), component, looks[component]);
  }
  for (const float channel : scene.Draw())
  {
    EXPECT_TRUE(std::isfinite(channel));
  }
  EXPECT_TRUE(scene.UsesShaderPart("Gaps/Cells.glsl"));
}

TEST(Components, TakeTheirShadersAndChannelsOnlyWhereTheyAre)
{
  MapperScene scene(ImageOf(VTK_FLOAT, 3, BallValue, { 16, 16, 16 }), 16);
  scene.mapper->SetAccelerationModeToOff();
  scene.Draw();
  const std::vector<std::string> parts = scene.ShaderParts();
  const auto classify = std::find(parts.begin(), parts.end(), "Classify/ComponentTables.glsl");
  const auto march = std::find(classify, parts.end(), "March/MaterialSegments.glsl");
  EXPECT_EQ(std::vector<std::string>(classify, march),
    (std::vector<std::string>{ "Classify/ComponentTables.glsl", "Components/Independent.glsl",
      "Gradient/NoneOfAll.glsl", "Shade/None.glsl", "GradientOpacity/None.glsl", "Values/All.glsl",
      "Material/Components.glsl", "Blend/Composite.glsl", "Sky/None.glsl" }));
  const vtkIdType tables = scene.mapper->GetGraphicsMemoryBytes() - 16 * 16 * 16 * 3 * 4;
  EXPECT_EQ(tables % 16, 0);
  EXPECT_LE(tables, 3 * 1024 * 16);
}
