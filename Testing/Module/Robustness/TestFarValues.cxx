// Volumes in which a few voxels, such as fill values, are far beyond the values that matter, and
// ranges of values that doubles can hardly represent.

#include "Module/Scenes/ComponentVolumes.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace varimarch;

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

constexpr double LargestDouble = std::numeric_limits<double>::max();

struct Fill
{
  double value;
  int side; ///< voxels of a corner that have it, along each axis
};

// A blob of values from `shift` to `shift` + 255; a corner of it is filled.
vtkSmartPointer<vtkImageData> Blob(int type, const Fill& fill, double shift)
{
  return ImageOf(type, 1,
    [&](glm::ivec3 voxel, int)
    {
      const bool isFilled = std::max({ voxel.x, voxel.y, voxel.z }) < fill.side;
      const double distance = glm::length(glm::dvec3(voxel) - 8.0) / 8.0;
      return isFilled ? fill.value : shift + std::round(255.0 * std::max(1.0 - distance, 0.0));
    },
    { 17, 17, 17 });
}

// The scene of a blob, seen along z: the filled corner is in the lower left of the image.
struct BlobScene : MapperScene
{
  explicit BlobScene(const Fill& fill, int type = VTK_DOUBLE, double shift = 0.0)
    : MapperScene(Blob(type, fill, shift), 24)
  {
    this->LookDown({ 8.0, 8.0, 8.0 }, 9.0);
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(shift, 0.2, 0.6, 1.0);
    this->colors->AddRGBPoint(shift + 255.0, 1.0, 0.7, 0.3);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(shift + 60.0, 0.0);
    this->opacities->AddPoint(shift + 128.0, 0.15);
    this->opacities->AddPoint(shift + 255.0, 0.5);
    this->volume->GetProperty()->SetShade(false);
  }

  // The pixels whose rays pass the filled cells at a distance.
  std::vector<float> Beside(std::vector<float> picture) const
  {
    constexpr int Touched = 8;
    for (int y = 0; y < Touched; ++y)
    {
      std::fill_n(picture.begin() + 4 * y * this->size, 4 * Touched, 0.0f);
    }
    return picture;
  }
};

constexpr Fill Nothing = { 0.0, 0 };

const std::vector<Fill> FarFills = { { -1e20, 1 }, { -1e5, 1 }, { -LargestDouble, 2 } };

// Expects the same picture with each fill as without one, apart from the rays that touch it.
template <class Prepare>
void ExpectTheSameBesideFills(const std::vector<Fill>& fills, Prepare prepare)
{
  BlobScene without(Nothing);
  prepare(without);
  const std::vector<float> expected = without.Beside(without.Draw());
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.05f);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (const Fill& fill : fills)
    {
      if (type == VTK_FLOAT && std::abs(fill.value) > 3e38)
      {
        continue;
      }
      SCOPED_TRACE(testing::Message() << fill.value << ", type " << type);
      BlobScene filled(fill, type);
      prepare(filled);
      const std::vector<float> shaders = filled.Beside(filled.Draw());
      const std::vector<float> processor = filled.Beside(filled.DrawByProcessor());
      const ImageError error = LargerError(shaders, processor, expected);
      EXPECT_LT(error.largest, 0.6) << "of 255";
    }
  }
}

}

TEST(FarValues, ChangeNoRayThatMissesThem)
{
  for (const int acceleration : { Mapper::Off, Mapper::CellField, Mapper::OpticalField })
  {
    SCOPED_TRACE(acceleration);
    ExpectTheSameBesideFills(
      FarFills, [&](BlobScene& scene) { scene.mapper->SetAccelerationMode(acceleration); });
  }
}

TEST(FarValues, ChangeNoRayWhereTheFunctionEndsBeforeThem)
{
  ExpectTheSameBesideFills({ { 1e20, 3 }, { 9.97e36, 3 }, { LargestDouble, 3 } },
    [](BlobScene& scene)
    {
      scene.opacities->AddPoint(256.0, 0.0);
      scene.opacities->AddPoint(1000.0, 0.0);
    });
}

TEST(FarValues, ChangeNoLightOnALookThatIsTheSameForAllValues)
{
  ExpectTheSameBesideFills(FarFills,
    [](BlobScene& scene)
    {
      scene.colors->RemoveAllPoints();
      scene.colors->AddRGBPoint(0.0, 0.2, 0.6, 1.0);
      scene.opacities->RemoveAllPoints();
      scene.opacities->AddPoint(0.0, 0.1);
      scene.volume->GetProperty()->ShadeOn();
    });
}

TEST(FarValues, ChangeNoRayOfOtherRulesAndLooks)
{
  using Prepare = std::function<void(BlobScene&)>;
  const std::vector<Prepare> looks = {
    [](BlobScene& scene) { scene.mapper->SetIntegrationRule(Mapper::PreIntegrated); },
    [](BlobScene& scene) { scene.volume->GetProperty()->ShadeOn(); },
    [](BlobScene& scene) { scene.mapper->SetBlendModeToMaximumIntensity(); },
    [](BlobScene& scene) { scene.volume->GetProperty()->SetInterpolationTypeToNearest(); },
    [](BlobScene& scene)
    {
      // No voxel has this value: rounding would decide on which side of the step it lies.
      scene.opacities->AddPoint(100.5, 0.0);
      scene.opacities->AllowDuplicateScalarsOn();
      scene.opacities->AddPoint(100.5, 0.2);
    },
    [](BlobScene& scene)
    {
      vtkNew<vtkPiecewiseFunction> factors;
      factors->AddPoint(0.0, 0.0);
      factors->AddPoint(20.0, 0.3);
      factors->AddPoint(30.0, 1.0);
      scene.volume->GetProperty()->SetGradientOpacity(factors);
    },
    [](BlobScene& scene)
    {
      scene.mapper->SetBlendModeToIsoSurface();
      scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
    },
  };
  for (std::size_t look = 0; look < looks.size(); ++look)
  {
    SCOPED_TRACE(look);
    ExpectTheSameBesideFills({ { -1e20, 1 } }, looks[look]);
  }
}

// Floats tell values around 2^31 apart by 256 only, and a fill value at zero hides that the others
// are far from it.
TEST(FarValues, AtZeroLeaveTheOthersTheirPrecision)
{
  BlobScene without(Nothing);
  struct Numbers
  {
    int type;
    double shift;
  };
  for (const auto& [type, shift] :
    { Numbers{ VTK_INT, -1e8 + 100.0 }, Numbers{ VTK_INT, 2147483000.0 },
      Numbers{ VTK_UNSIGNED_INT, 4294967000.0 }, Numbers{ VTK_LONG_LONG, 1e12 },
      Numbers{ VTK_UNSIGNED_LONG, 1e12 }, Numbers{ VTK_DOUBLE, -1e12 } })
  {
    SCOPED_TRACE(testing::Message() << shift << ", type " << type);
    for (const int blend : { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND })
    {
      without.mapper->SetBlendMode(blend);
      const std::vector<float> expected = without.Beside(without.Draw());
      BlobScene filled({ 0.0, 2 }, type, shift);
      filled.mapper->SetBlendMode(blend);
      const ImageError error = LargerError(
        filled.Beside(filled.Draw()), filled.Beside(filled.DrawByProcessor()), expected);
      EXPECT_LT(error.largest, 0.6) << "of 255, blend mode " << blend;
    }
  }
}

TEST(FarValues, FromZeroAreInterpolatedWhateverTheirType)
{
  for (const int type : { VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    SCOPED_TRACE(type);
    const auto image = ImageOf(
      type, 1, [](glm::ivec3 voxel, int) { return 1e7 + (voxel.x + voxel.y + voxel.z) % 4; });
    MapperScene scene(image, 24);
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(1e7 + 1.0, 0.0);
    scene.opacities->AddPoint(1e7 + 3.0, 0.5);
    scene.mapper->AutoAdjustSampleDistancesOff();
    scene.mapper->SetSampleDistance(0.02);
    EXPECT_LT(scene.Error().largest, 1.0) << "of 255";
  }
}

TEST(FarValues, ThatAreAllTheSameAreCountedInAnAverage)
{
  constexpr double Value = 16219916300.0;
  MapperScene scene(ImageOf(VTK_DOUBLE, 1, [](glm::ivec3, int) { return Value; }), 9);
  LookAlongZ(scene);
  scene.mapper->SetBlendModeToAverageIntensity();
  scene.mapper->SetAverageIPScalarRange(Value - 30.0, Value + 100.0);
  EXPECT_EQ(scene.MiddlePixel()[3], 1.0f);
  scene.mapper->SetAverageIPScalarRange(Value + 30.0, Value + 100.0);
  EXPECT_EQ(scene.MiddlePixel()[3], 0.0f);
}

TEST(FarValues, OutsideTheAveragedRangeChangeNoAverage)
{
  ExpectTheSameBesideFills({ { -1e20, 1 }, { 1e20, 1 }, { -LargestDouble, 2 } },
    [](BlobScene& scene)
    {
      scene.mapper->SetBlendModeToAverageIntensity();
      scene.mapper->SetAverageIPScalarRange(0.0, 255.0);
      scene.opacities->AddPoint(0.0, 1.0);
      scene.opacities->AddPoint(255.0, 1.0);
    });
}

TEST(FarValues, AreUploadedAgainOnlyWhenTheLookNeedsIt)
{
  BlobScene scene({ 1e20, 1 });
  scene.Draw();
  const int builds = scene.mapper->GetVolumeTextureBuilds();
  scene.opacities->AddPoint(200.0, 0.3);
  scene.opacities->AddPoint(400.0, 0.6);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), builds);
  scene.opacities->AddPoint(1e7, 0.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), builds + 1);
}

TEST(FarValues, ThatAFunctionReachesMakeItsErrorUnknown)
{
  BlobScene scene({ 1e20, 1 });
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.opacities->AddPoint(1e20, 1.0);
  ExpectedVtkErrors warnings;
  scene.Draw();
  EXPECT_NE(warnings.Text().find("may be wrong by any amount"), std::string::npos);
  EXPECT_EQ(scene.mapper->GetEstimatedError(), 1.0);
  EXPECT_FALSE(scene.mapper->GetErrorToleranceIsKept());
}

TEST(FarValues, OfASumOrMeanMakeItsErrorUnknown)
{
  for (const int blend : { Mapper::ADDITIVE_BLEND, Mapper::AVERAGE_INTENSITY_BLEND })
  {
    SCOPED_TRACE(blend);
    BlobScene scene({ -1e20, 1 });
    scene.mapper->SetBlendMode(blend);
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
    ExpectedVtkErrors warnings;
    scene.Draw();
    EXPECT_NE(warnings.Text().find("Replace far values"), std::string::npos) << warnings.Text();
    EXPECT_EQ(scene.mapper->GetEstimatedError(), 1.0);
    EXPECT_FALSE(scene.mapper->GetErrorToleranceIsKept());
  }
}

// Values up to this distance are as exact as they must be.
TEST(FarValues, OfASumThatStayDistinctAreNoWarning)
{
  BlobScene scene({ -1e5, 1 });
  scene.mapper->SetBlendModeToAdditive();
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  EXPECT_LT(scene.Error().percentile999, 255.0 / 64.0);
  EXPECT_TRUE(scene.mapper->GetErrorToleranceIsKept());
}

TEST(FarValues, OfTheLargestDoublesAreDrawn)
{
  BlobScene scene({ LargestDouble, 1 });
  scene.image->SetScalarComponentFromDouble(16, 16, 16, 0, -LargestDouble);
  const std::vector<float> expected = scene.Beside(BlobScene(Nothing).Draw());
  const std::vector<float> drawn = scene.Beside(scene.Draw());
  EXPECT_LT(CompareImages(drawn.data(), expected.data(), expected.size() / 4).percentile999, 0.6);
}

TEST(FarValues, WithDifferencesTooSmallForDoublesAreOneSentence)
{
  for (const double value : { 5e-324, 1e-310, 2.5e-306 })
  {
    MapperScene scene(
      ImageOf(
        VTK_DOUBLE, 1, [&](glm::ivec3 voxel, int) { return voxel == glm::ivec3(4) ? value : 0.0; }),
      8);
    scene.opacities->AddPoint(value, 0.5);
    ExpectedVtkErrors errors;
    scene.Draw();
    EXPECT_NE(errors.Text().find("multiply them by a large number"), std::string::npos) << value;
  }
}

TEST(FarValues, OfColoursInFloatsUpTo255AreBytes)
{
  MapperScene scene(ImageOf(VTK_DOUBLE, 4,
                      [](glm::ivec3, int component) {
                        return std::array<double, 4>{ 204.0, 102.0, 51.0, 100.0 }[component];
                      }),
    9);
  LookAlongZ(scene);
  scene.volume->GetProperty()->IndependentComponentsOff();
  SetLook(scene.volume->GetProperty(), 0, { glm::dvec3(0.0), 0.0, 100.0, 0.2 });
  const std::array<float, 4> drawn = scene.MiddlePixel();
  EXPECT_NEAR(drawn[0], 0.8 * drawn[3], 1e-3);
  EXPECT_NEAR(drawn[1], 0.4 * drawn[3], 1e-3);
  EXPECT_NEAR(drawn[2], 0.2 * drawn[3], 1e-3);
}
