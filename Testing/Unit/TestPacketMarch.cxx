// Packets of rays with every instruction set of this processor.

#include "Unit/PacketPictures.h"

#include "Core/Fields/OpticalField.h"
#include "Core/Geometry/SplineCoefficients.h"
#include "Core/Quality/BlueNoise.h"
#include "Core/Quality/ImageError.h"
#include "Core/Reference/SplineGrid.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// One 50th of 1/255: the rounding of single precision over thousands of samples.
constexpr double RoundOff = 0.02;

class PacketMarch : public testing::TestWithParam<InstructionSet>
{
protected:
  std::vector<float> March() const { return this->pictures.March(GetParam()); }

  /// @param rootMeanSquare, percentile999  in units of 1/255
  void ExpectTruth(double rootMeanSquare, double percentile999) const
  {
    const std::vector<float> truth = this->pictures.Truth();
    EXPECT_GT(*std::max_element(truth.begin(), truth.end()), 0.3) << "the image is empty";
    const ImageError error = CompareImages(this->March().data(), truth.data(), truth.size() / 4);
    EXPECT_LT(error.rootMeanSquare, rootMeanSquare);
    EXPECT_LT(error.percentile999, percentile999);
  }

  static void ExpectEqual(const std::vector<float>& a, const std::vector<float>& b)
  {
    const ImageError difference = CompareImages(a.data(), b.data(), a.size() / 4);
    EXPECT_LT(difference.percentile999, RoundOff);
  }

  PacketPictures pictures;
  PacketScene& scene = pictures.scene;
  ReferenceScene& truth = pictures.truth;
};

/// Properties of the voxel whose box, half a voxel to each side, contains a position.
OpticalProperties OfNearestVoxel(const PacketPictures& pictures, const glm::dvec3& positionGrid)
{
  const glm::ivec3 voxel =
    glm::clamp(glm::ivec3(positionGrid + 0.5), glm::ivec3(0), PacketPictures::Dimensions - 1);
  const TransferFunction& look = pictures.truth.transferFunction;
  const double value = pictures.Grid().Voxel(voxel);
  return { look.Color(value), look.Extinction(value) };
}

}

TEST_P(PacketMarch, ByMidpointsConvergesToTheIntegral)
{
  this->ExpectTruth(RoundOff, 0.1);
}

TEST_P(PacketMarch, OfPreIntegratedSegmentsConvergesToTheIntegral)
{
  this->pictures.PreIntegrate();
  this->ExpectTruth(0.05, 0.3);
}

TEST_P(PacketMarch, OfALitMaterialConvergesToTheIntegral)
{
  this->pictures.LightFromTheEye();
  for (PacketRule rule : { PacketRule::MaterialMidpoint, PacketRule::MaterialLinear })
  {
    this->scene.rule = rule;
    this->ExpectTruth(0.05, 0.3);
  }
}

TEST_P(PacketMarch, FindsTheMaximumOfTheReference)
{
  this->scene.rule = PacketRule::Extreme;
  this->truth.blend = Blend::MaximumIntensity;
  this->ExpectTruth(RoundOff, 0.1);
}

TEST_P(PacketMarch, MeetsTheIsosurfacesOfTheReference)
{
  const std::vector<double> isovalues = { 50.0, 80.0 };
  std::vector<glm::vec4> entries;
  for (double isovalue : isovalues)
  {
    const double opacity = this->truth.transferFunction.Opacity(isovalue);
    entries.emplace_back(this->truth.transferFunction.Color(isovalue), -std::log1p(-opacity));
    entries.emplace_back(isovalue);
  }
  this->pictures.LightFromTheEye();
  this->scene.rule = PacketRule::Isosurfaces;
  this->scene.textures.isosurfaces.inMemory = entries.data();
  this->scene.parameters.isosurfaceCount = int(isovalues.size());
  this->truth.blend = Blend::Isosurface;
  this->truth.isovalues = isovalues;
  this->ExpectTruth(0.05, 0.3);
}

TEST_P(PacketMarch, HasTheMeanOfTheReference)
{
  this->scene.rule = PacketRule::Projection;
  this->truth.blend = Blend::AverageIntensity;
  this->ExpectTruth(0.05, 0.3);
}

TEST_P(PacketMarch, WithoutInterpolationIsExact)
{
  this->scene.rule = PacketRule::Voxels;
  this->truth.material = [this](const glm::dvec3& position, const Ray&)
  { return OfNearestVoxel(this->pictures, position); };
  this->ExpectTruth(RoundOff, 0.1);
}

TEST_P(PacketMarch, ThroughASplineConvergesToTheIntegral)
{
  std::vector<float> coefficients = this->pictures.Converted<float>();
  TurnIntoSplineCoefficients(coefficients.data(), PacketPictures::Dimensions);
  this->scene.volume.voxels = coefficients.data();
  this->scene.volume.type = VoxelType::Float32;
  this->scene.volume.areOfSpline = true;
  const SplineGrid spline(this->pictures.Converted<double>(), PacketPictures::Dimensions);
  this->truth.material = [&](const glm::dvec3& position, const Ray&)
  {
    const double value = spline.Value(position);
    const TransferFunction& look = this->truth.transferFunction;
    return OpticalProperties{ look.Color(value), look.Extinction(value) };
  };
  this->ExpectTruth(0.05, 0.3);
}

TEST_P(PacketMarch, ReadsAllTypesOfVoxelsAlike)
{
  const std::vector<float> image = this->March();
  const auto expectSame = [&](VoxelType type, const auto& voxels)
  {
    this->scene.volume.type = type;
    this->scene.volume.voxels = voxels.data();
    ExpectEqual(this->March(), image);
  };
  expectSame(VoxelType::Int8, this->pictures.Converted<std::int8_t>());
  expectSame(VoxelType::UInt8, this->pictures.Converted<std::uint8_t>());
  expectSame(VoxelType::UInt16, this->pictures.Converted<std::uint16_t>());
  expectSame(VoxelType::Float32, this->pictures.Converted<float>());
}

TEST_P(PacketMarch, OfAMixtureOfHalvesIsThatOfTheWhole)
{
  const std::vector<float> whole = this->March();
  this->scene.constituent.isOfMixture = true;
  this->scene.parameters.partWeights = glm::dvec4(0.5);
  const PacketScene other = this->scene;
  this->scene.constituent.others = &other;
  this->scene.constituent.otherCount = 1;
  ExpectEqual(this->March(), whole);
}

TEST_P(PacketMarch, SkipsNothingThatIsSeen)
{
  const BrickRanges ranges = BuildBrickRanges(this->pictures.Grid(), 0.0, 100.0);
  const OpticalField field =
    BuildOpticalField(ranges, this->pictures.Table(), OpticalTolerance::Nothing(20.0));
  ASSERT_GT(std::count_if(field.bricks.begin(), field.bricks.end(),
              [](std::uint8_t brick) { return brick >= OpticalField::Invisible; }),
    0);
  this->scene.steps.grow = true;
  this->scene.steps.bricks = field.bricks.data();
  this->scene.steps.brickCount = field.brickCount;
  this->scene.parameters.cellsPerBrick = float(BrickRanges::CellsPerSide);
  this->ExpectTruth(RoundOff, 0.1);
}

TEST_P(PacketMarch, InPiecesAddsUpToTheWhole)
{
  const std::vector<float> whole = this->March();
  shader::vec4* const planes = this->scene.rays.croppingPlanes;
  for (int axis = 0; axis < 3; ++axis)
  {
    planes[2 * axis] = planes[2 * axis + 1] = glm::vec4(0.0f);
    planes[2 * axis][axis] = planes[2 * axis + 1][axis] = 1.0f;
    planes[2 * axis].w = -3.2f;
    planes[2 * axis + 1].w = -7.1f;
  }
  this->scene.rays.croppingRegions = (1 << 27) - 1;
  ExpectEqual(this->March(), whole);
}

TEST_P(PacketMarch, IsTheSameWithAnyNumberOfThreads)
{
  const std::vector<float> usual = this->March();
  for (const int count : { 1, 64 })
  {
    const tbb::global_control control(
      tbb::global_control::max_allowed_parallelism, std::size_t(count));
    tbb::task_arena arena(count);
    EXPECT_EQ(arena.execute([&] { return this->March(); }), usual) << count << " threads";
  }
}

TEST_P(PacketMarch, IsThatOfTheBaseline)
{
  // With light, noise and a clipping plane, bits differ because of fused multiplications and
  // estimated roots.
  const std::vector<std::uint16_t> noise = BlueNoiseTile(16);
  const glm::vec4 plane(0.3f, 0.5f, -0.4f, 1.0f);
  this->pictures.LightFromTheEye();
  this->scene.rule = PacketRule::MaterialLinear;
  this->scene.rays.stepMm = 0.5f;
  this->scene.rayTextures.noiseTexture.inMemory = noise.data();
  this->scene.rays.noisePixelsMask = glm::ivec2(15);
  this->scene.rayTextures.clippingPlanes.inMemory = &plane;
  this->scene.rays.clippingPlaneCount = 1;
  ExpectEqual(this->March(), this->pictures.March(InstructionSet::Baseline));
}

INSTANTIATE_TEST_SUITE_P(On, PacketMarch, testing::ValuesIn(InstructionSetsOfProcessor()),
  [](const testing::TestParamInfo<InstructionSet>& info)
  { return info.param == InstructionSet::Avx2 ? "Avx2" : "Baseline"; });
