// The loops of Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016), against
// transcriptions of their text, and their settings: first distance, number of steps, step in
// voxels.

#include "Core/Fields/VariationField.h"
#include "Frame/PropertyTransferFunction.h"
#include "Module/Scenes/HomogeneousScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

constexpr double Variation = 60.0; // E in units of the torso's values
constexpr double StepVoxels = 0.7;
constexpr int Steps = 22;

// A torso whose voxels are cubes of 2 mm, seen along -z. Rays do not meet the middle between
// voxels, where rounding would decide which is the nearest.
class TorsoScene : public MapperScene
{
public:
  explicit TorsoScene(const std::function<void(vtkPiecewiseFunction*)>& setOpacities = {})
    : MapperScene(CubicTorso(), 24)
    , transferFunction(FunctionOf(*this, setOpacities))
    , grid(static_cast<const short*>(this->image->GetScalarPointer()), { 40, 36, 24 })
    , field(BuildVariationField(this->grid, Variation, VoxelDistance::Euclidean))
  {
    this->volume->GetProperty()->ShadeOff();
    this->LookDown({ 39.0, 35.0, 20.0 }, HalfMm);
    this->renderer->GetActiveCamera()->SetPosition(39.0, 35.0, EyeZMm);
    this->renderer->GetActiveCamera()->SetClippingRange(1.0, 1000.0);
    this->mapper->AutoAdjustSampleDistancesOff();
    this->mapper->SetSampleDistanceInVoxels(StepVoxels);
    this->mapper->SetEarlyTerminationTransmittance(0.0);
    this->mapper->SetVariationTolerance(Variation);
    this->mapper->SetIntegrationRule(Mapper::PublishedSum);
  }

  // The image of a loop that returns the colour of a ray, which goes from `start` along -z.
  template <class Loop>
  std::vector<float> PictureOf(const Loop& loop) const
  {
    std::vector<float> picture;
    for (int y = 0; y < this->size; ++y)
    {
      for (int x = 0; x < this->size; ++x)
      {
        const auto place = [&](int pixel, double middle)
        { return (middle + HalfMm * (2.0 * (pixel + 0.5) / this->size - 1.0)) / VoxelMm; };
        const glm::dvec4 color = loop(glm::dvec3(place(x, 39.0), place(y, 35.0), 23.0));
        picture.insert(
          picture.end(), { float(color.r), float(color.g), float(color.b), float(color.a) });
      }
    }
    return picture;
  }

  double LargestDifference(const std::vector<float>& picture)
  {
    const std::vector<float> drawn = this->Draw();
    EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1f) << "the picture is empty";
    return CompareImages(drawn.data(), picture.data(), picture.size() / 4).largest;
  }

  // VR(I): colour and opacity of one step.
  glm::dvec4 Sample(glm::dvec3 p) const
  {
    const double value = this->grid.Value(p);
    const double depth = this->transferFunction.Extinction(value) * StepVoxels * VoxelMm;
    return glm::dvec4(this->transferFunction.Color(value), -std::expm1(-depth));
  }

  double DistanceAt(glm::dvec3 p) const
  {
    const glm::ivec3 voxel(glm::floor(p + 0.5));
    return this->field.voxels[(std::size_t(voxel.z) * 36 + voxel.y) * 40 + voxel.x];
  }

  static constexpr double VoxelMm = 2.0;
  static constexpr double HalfMm = 29.3;
  static constexpr double EyeZMm = 60.0;
  static constexpr double FaceZMm = 46.0; // the face of the volume that rays enter

private:
  static TransferFunction FunctionOf(
    MapperScene& scene, const std::function<void(vtkPiecewiseFunction*)>& setOpacities)
  {
    if (setOpacities)
    {
      setOpacities(scene.opacities);
    }
    return TransferFunctionOf(scene.volume->GetProperty());
  }

  static vtkSmartPointer<vtkImageData> CubicTorso()
  {
    auto torso = SmallTorso();
    torso->SetSpacing(VoxelMm, VoxelMm, VoxelMm);
    torso->SetOrigin(0.0, 0.0, 0.0);
    return torso;
  }

  TransferFunction transferFunction;
  ScalarGrid<short> grid;
  VariationField field;
};

// The printed loop, with its numbers of lines. Ours counts the last sample only to the end of the
// ray.
glm::dvec4 PrintedLoop(const TorsoScene& scene, glm::dvec3 start, bool hasField, int cantSteps)
{
  glm::dvec3 C(0.0); // 1
  double transmittance = 1.0;
  double t = 0.0; // 2
  double i = 0.0; // 3
  const double end = std::min(start.z, cantSteps * StepVoxels);
  while (i < cantSteps - 1e-9 && t < end) // 4
  {
    const glm::dvec3 p = start - glm::dvec3(0.0, 0.0, t);         // 6
    const glm::dvec4 sample = scene.Sample(p);                    // 7
    const double S = hasField ? scene.DistanceAt(p) : StepVoxels; // 8
    const double d = std::min(S, end - t);
    const double s = d / StepVoxels;                        // 9
    C += transmittance * sample.a * s * glm::dvec3(sample); // 10
    transmittance = std::max(transmittance * (1.0 - sample.a * s), 0.0);
    t = t + S; // 11
    i = i + s; // 12
  }
  return glm::dvec4(C, 1.0 - transmittance);
}

constexpr double Rounding255 = 0.05; // tables and floats, in 1/255

}

TEST(PublishedLoop, IsDrawnLineByLine)
{
  TorsoScene scene;
  scene.mapper->SetAccelerationModeToVariationField();
  EXPECT_LT(scene.LargestDifference(scene.PictureOf(
              [&](glm::dvec3 start) { return PrintedLoop(scene, start, true, 1000); })),
    Rounding255);
  EXPECT_TRUE(scene.UsesShaderPart("Step/VariationField.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("March/PublishedSum.glsl"));
}

TEST(PublishedLoop, EndsAfterItsNumberOfSteps)
{
  TorsoScene scene;
  scene.mapper->SetMaximumNumberOfSteps(Steps);
  for (const bool hasField : { true, false })
  {
    scene.mapper->SetAccelerationMode(hasField ? Mapper::VariationField : Mapper::Off);
    EXPECT_LT(scene.LargestDifference(scene.PictureOf(
                [&](glm::dvec3 start) { return PrintedLoop(scene, start, hasField, Steps); })),
      Rounding255)
      << hasField;
  }
}

TEST(PublishedLoop, BeginsAtItsFirstDistance)
{
  TorsoScene scene;
  scene.mapper->SetAccelerationModeToVariationField();
  scene.mapper->SetMaximumNumberOfSteps(Steps);
  const double voxelsInside = 5.0;
  scene.mapper->SetFirstDistance(
    TorsoScene::EyeZMm - TorsoScene::FaceZMm + voxelsInside * TorsoScene::VoxelMm);
  const auto loop = [&](glm::dvec3 start)
  { return PrintedLoop(scene, start - glm::dvec3(0.0, 0.0, voxelsInside), true, Steps); };
  EXPECT_LT(scene.LargestDifference(scene.PictureOf(loop)), Rounding255);
}

TEST(PublishedLoop, CountsStepsFromTheFaceOfTheWholeInBlocks)
{
  TorsoScene scene;
  scene.mapper->SetIntegrationRule(Mapper::Midpoint);
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetSampleDistanceInVoxels(1.0 / 64.0);
  scene.mapper->SetMaximumNumberOfSteps(64 * 15);
  const std::vector<float> whole = scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart("Resume/Block.glsl"));
  scene.mapper->SetMaximumGraphicsMemory(60000);
  EXPECT_LT(scene.LargestDifference(whole), 0.5);
  EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
}

namespace
{

// Fine steps to an opacity above one half in the unit distance, then samples.
glm::dvec4 FirstHitLoop(const TorsoScene& scene, glm::dvec3 start, double stepsPerUnit, int samples)
{
  glm::dvec3 p = start;
  while (p.z > 0.0 && 1.0 - std::pow(1.0 - scene.Sample(p).a, stepsPerUnit) <= 0.5)
  {
    p.z -= StepVoxels / 8.0;
  }
  glm::dvec3 C(0.0);
  double transmittance = 1.0;
  for (int i = 0; i < samples && p.z > 0.0; ++i)
  {
    const glm::dvec4 sample = scene.Sample(p);
    const double part = std::min(1.0, p.z / StepVoxels); // the last sample ends with the volume
    const double opacity = 1.0 - std::pow(1.0 - sample.a, part);
    C += transmittance * opacity * glm::dvec3(sample);
    transmittance *= 1.0 - opacity;
    p.z -= StepVoxels;
  }
  return glm::dvec4(C, 1.0 - transmittance);
}

}

TEST(FirstHit, TakesItsSamplesBehindTheFirstOpaqueOne)
{
  TorsoScene scene(
    [](vtkPiecewiseFunction* opacities)
    {
      opacities->RemoveAllPoints();
      opacities->AddPoint(-50.0, 0.0);
      opacities->AddPoint(400.0, 0.95);
    });
  constexpr int Samples = 5;
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetIntegrationRule(Mapper::FirstHit);
  scene.mapper->SetMaximumNumberOfSteps(Samples);
  const double unitMm = scene.volume->GetProperty()->GetScalarOpacityUnitDistance();
  const double stepsPerUnit = unitMm / (StepVoxels * TorsoScene::VoxelMm);
  const std::vector<float> picture = scene.PictureOf(
    [&](glm::dvec3 start) { return FirstHitLoop(scene, start, stepsPerUnit, Samples); });
  const std::vector<float> drawn = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("March/FirstHit.glsl"));
  // A value close to the threshold may be found one fine step later.
  const ImageError error = CompareImages(drawn.data(), picture.data(), picture.size() / 4);
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.5f) << "nothing is hit";
  EXPECT_EQ(*std::min_element(drawn.begin(), drawn.end()), 0.0f)
    << "something is drawn without a hit";
}

class Span : public testing::TestWithParam<int>
{
public:
  // The largest difference from a material of this length, by shaders and by packets [1].
  static double ErrorOf(HomogeneousScene& scene, double lengthMm)
  {
    double largest = 0.0;
    const std::array<double, 4> piece = scene.Piece(lengthMm);
    for (const std::vector<float>& drawn : { scene.Draw(), scene.DrawByProcessor() })
    {
      for (std::size_t i = 0; i < drawn.size(); ++i)
      {
        largest = std::max(largest, std::abs(drawn[i] - piece[i % 4]));
      }
    }
    return largest;
  }

  static constexpr double EyeMm = 100.0;
  static constexpr double HalfMm = HomogeneousScene::SideMm / 2.0;
  static constexpr double Rounding = 1e-4;
};

TEST_P(Span, BeginsAtADistanceFromTheEye)
{
  HomogeneousScene scene;
  scene.mapper->SetAccelerationMode(GetParam());
  scene.mapper->SetFirstDistance(EyeMm - 3.0);
  EXPECT_LT(ErrorOf(scene, HalfMm + 3.0), Rounding);
  scene.mapper->SetFirstDistance(EyeMm - HalfMm - 1.0);
  EXPECT_LT(ErrorOf(scene, 2.0 * HalfMm), Rounding) << "a distance in front of the volume";
  scene.mapper->SetFirstDistance(EyeMm + HalfMm + 1.0);
  EXPECT_LT(ErrorOf(scene, 0.0), Rounding) << "a distance behind the volume";
}

TEST_P(Span, EndsAfterANumberOfSteps)
{
  HomogeneousScene scene;
  scene.mapper->SetAccelerationMode(GetParam());
  scene.mapper->SetMaximumNumberOfSteps(10);
  EXPECT_LT(ErrorOf(scene, 2.0 * HalfMm), Rounding) << "steps of no known length";
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.5);
  EXPECT_LT(ErrorOf(scene, 5.0), Rounding);
  scene.mapper->SetFirstDistance(EyeMm);
  EXPECT_LT(ErrorOf(scene, 5.0), Rounding) << "in the volume, steps count from the first distance";
  scene.mapper->SetMaximumNumberOfSteps(100);
  EXPECT_LT(ErrorOf(scene, HalfMm), Rounding) << "the ray ends with the volume";
  scene.mapper->SetSampleDistanceInVoxels(0.25);
  scene.mapper->SetMaximumNumberOfSteps(4);
  EXPECT_LT(ErrorOf(scene, scene.image->GetSpacing()[0]), Rounding) << "a step in voxels";
}

INSTANTIATE_TEST_SUITE_P(EveryField, Span,
  testing::Values(Mapper::Off + 0, Mapper::CellField + 0, Mapper::OpticalField + 0));

TEST(SpanInPerspective, IsASphereAroundAnEyeInTheVolume)
{
  HomogeneousScene scene;
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetViewAngle(80.0);
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetClippingRange(0.01, 1000.0);
  constexpr double FirstMm = 3.0;
  scene.mapper->SetFirstDistance(FirstMm);
  for (const std::vector<float>& drawn : { scene.Draw(), scene.DrawByProcessor() })
  {
    for (int i = 0; i < scene.size * scene.size; ++i)
    {
      const auto slope = [&](int pixel)
      { return std::tan(glm::radians(40.0)) * (2.0 * (pixel + 0.5) / scene.size - 1.0); };
      const double perDepth =
        glm::length(glm::dvec3(slope(i % scene.size), slope(i / scene.size), 1.0));
      const double lengthMm = perDepth * HomogeneousScene::SideMm / 2.0 - FirstMm;
      ASSERT_NEAR(drawn[4 * i + 3], scene.Piece(lengthMm)[3], 1e-4) << "pixel " << i;
    }
  }
}

TEST(PublishedRules, AreRefusedWhereAnotherRuleWouldBeDrawn)
{
  const std::vector<std::function<void(TorsoScene&)>> changes = {
    [](TorsoScene& scene) { scene.volume->GetProperty()->ShadeOn(); },
    [](TorsoScene& scene) { scene.volume->GetProperty()->SetInterpolationTypeToNearest(); },
    [](TorsoScene& scene) { scene.mapper->SetAmbientOcclusion(0.5); },
    [](TorsoScene& scene) { scene.mapper->SetCompositingOrderToBackToFront(); },
  };
  for (const int rule : { Mapper::PublishedSum, Mapper::FirstHit })
  {
    const std::string name = rule == Mapper::FirstHit ? "FirstHit" : "PublishedSum";
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      TorsoScene scene;
      scene.mapper->SetIntegrationRule(rule);
      changes[i](scene);
      const ExpectedVtkErrors errors;
      const std::vector<float> picture = scene.Draw();
      EXPECT_EQ(*std::max_element(picture.begin(), picture.end()), 0.0f) << name << " " << i;
      EXPECT_NE(errors.Text().find("The integration rule " + name), std::string::npos) << i;
      scene.mapper->SetBlendModeToMaximumIntensity();
      const std::vector<float> maximum = scene.Draw();
      EXPECT_GT(*std::max_element(maximum.begin(), maximum.end()), 0.0f) << "it has no rule";
    }
  }
}
