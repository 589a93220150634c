// Behaviour at the limits of numbers, geometries and transfer functions.

#include "Module/Scenes/MapperScene.h"
#include "Stages/ExtremeScenes.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;
using namespace varimarch;

// The scene with the mapper's default error tolerance.
std::unique_ptr<MapperScene> MapperSceneOf(
  const ExtremeScene& extreme, int size, vtkHeadlessRenderWindow* window)
{
  auto scene = std::make_unique<MapperScene>(extreme.image(), size, window);
  scene->mapper->SetErrorTolerance(1.0 / 64.0);
  extreme.prepare(*scene);
  return scene;
}

std::string Describe(Mapper* mapper)
{
  return "acceleration " + std::to_string(mapper->GetAccelerationMode()) + ", rule " +
    std::to_string(mapper->GetIntegrationRule()) + ", blend mode " +
    std::to_string(mapper->GetBlendMode()) + ", tolerance " +
    std::to_string(mapper->GetErrorTolerance());
}

// Requires finite colours and opacities within [0, 1].
void ExpectPicture(MapperScene& scene)
{
  const std::vector<float> drawn = scene.Draw();
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const bool good =
      std::isfinite(drawn[i]) && drawn[i] >= 0.0f && (i % 4 != 3 || drawn[i] <= 1.0f);
    ASSERT_TRUE(good) << drawn[i] << " in channel " << i % 4 << " of pixel " << i / 4 << ", "
                      << Describe(scene.mapper);
  }
}

// Calls test() with every way in which a mapper may render the scene.
template <class Test>
void ForEveryRecipe(MapperScene& scene, Test test)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  for (int acceleration : { Mapper::Off, Mapper::CellField, Mapper::OpticalField })
  {
    scene.mapper->SetAccelerationMode(acceleration);
    scene.mapper->SetBlendModeToComposite();
    for (int rule = Mapper::Automatic; rule <= Mapper::PublishedSum; ++rule)
    {
      scene.mapper->SetIntegrationRule(rule);
      test();
    }
    scene.mapper->SetIntegrationRule(Mapper::Automatic); // light has no published rule
    property->ShadeOn();
    test();
    property->ShadeOff();
    for (int blend : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::MINIMUM_INTENSITY_BLEND,
           Mapper::AVERAGE_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND })
    {
      scene.mapper->SetBlendMode(blend);
      test();
    }
  }
}

void ExpectNothingButNumbers(const std::vector<ExtremeScene>& scenes)
{
  // One window for all scenes compiles each shader once.
  vtkNew<vtkHeadlessRenderWindow> window;
  ExpectedVtkErrors warnings;
  for (const ExtremeScene& extreme : scenes)
  {
    SCOPED_TRACE(extreme.name);
    const auto scene = MapperSceneOf(extreme, 4, window);
    ForEveryRecipe(*scene, [&] { ExpectPicture(*scene); });
    if (scene->mapper->GetErrorTolerance() > 0.0)
    {
      scene->mapper->SetErrorTolerance(0.0);
      ForEveryRecipe(*scene, [&] { ExpectPicture(*scene); });
    }
  }
}

}

TEST(Extremes, MaterialsGiveFiniteImages)
{
  ExpectNothingButNumbers(ExtremeMaterials());
  ExpectNothingButNumbers(HardSurfaces());
}

TEST(Extremes, ScalarsGiveFiniteImages)
{
  ExpectNothingButNumbers(ExtremeScalars());
}

TEST(Extremes, ShapesGiveFiniteImages)
{
  ExpectNothingButNumbers(ThinShapes());
  ExpectNothingButNumbers(ExtremeShapes());
}

TEST(Extremes, ViewsGiveFiniteImages)
{
  ExpectNothingButNumbers(ExtremeViews());
}

TEST(Extremes, SampleDistancesGiveFiniteImages)
{
  ExpectNothingButNumbers(ExtremesWithoutTolerance());
}

namespace
{

struct Judged
{
  varimarch::ImageError error; ///< in 1/255
  double offPart;              ///< fraction of pixels that are off by more than the tolerance
  double offEverywherePart;    ///< fraction of those that no ray within a tenth of a pixel explains
  bool warned;
  bool extreme; ///< true if one value of each ray decides
};

double OffPart(const std::vector<float>& drawn, const std::vector<float>& truth, double tolerance)
{
  int off = 0;
  for (std::size_t pixel = 0; pixel < drawn.size(); pixel += 4)
  {
    off += !std::equal(&drawn[pixel], &drawn[pixel] + 4, &truth[pixel],
      [&](float a, float b) { return std::abs(a - b) <= tolerance; });
  }
  return 4.0 * off / double(drawn.size());
}

// Lower and upper bounds of the reference for rays within a tenth of a pixel, widened by the
// tolerance.
struct Surroundings
{
  std::vector<float> lower;
  std::vector<float> upper;
};

Surroundings SurroundingsOf(MapperScene& scene, const std::vector<float>& truth)
{
  constexpr double distancePixels = 0.1;
  constexpr int directions = 8;
  Surroundings surroundings{ truth, truth };
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  for (int i = 0; i < directions; ++i)
  {
    const double angle = 6.2831853 * i / directions;
    const double shift = 2.0 * distancePixels / scene.size;
    camera->SetWindowCenter(shift * std::cos(angle), shift * std::sin(angle));
    const std::vector<float> beside = scene.Truth();
    for (std::size_t k = 0; k < truth.size(); ++k)
    {
      surroundings.lower[k] = std::min(surroundings.lower[k], beside[k]);
      surroundings.upper[k] = std::max(surroundings.upper[k], beside[k]);
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  return surroundings;
}

// A pixel at a discontinuity is right if a neighbouring ray gives the same colour.
double OffEverywherePart(
  MapperScene& scene, const std::vector<float>& drawn, std::vector<float> truth, double tolerance)
{
  const Surroundings surroundings = SurroundingsOf(scene, truth);
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    truth[k] = std::clamp(drawn[k], surroundings.lower[k], surroundings.upper[k]);
  }
  return OffPart(drawn, truth, tolerance);
}

// Calls expect() with the errors of each of the scene's images with the mapper's defaults.
template <class Expect>
void JudgeEveryBlend(const ExtremeScene& extreme, vtkHeadlessRenderWindow* window, Expect expect)
{
  for (int blend :
    { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND })
  {
    for (bool shaded : { false, true })
    {
      if (shaded && blend != Mapper::COMPOSITE_BLEND)
      {
        continue;
      }
      const auto scene = MapperSceneOf(extreme, 48, window);
      scene->mapper->SetBlendMode(blend);
      scene->volume->GetProperty()->SetShade(shaded);
      SCOPED_TRACE(extreme.name + (shaded ? ", shaded, " : ", ") + Describe(scene->mapper));
      ExpectedVtkErrors warnings;
      const std::vector<float> drawn = scene->Draw();
      EXPECT_EQ(scene->mapper->GetErrorToleranceIsKept(),
        warnings.Text().find("cannot be kept") == std::string::npos);
      const std::vector<float> truth = scene->Truth();
      const double tolerance = scene->mapper->GetErrorTolerance();
      const double offPart = OffPart(drawn, truth, tolerance);
      expect({ varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4), offPart,
        offPart > 0.0 ? OffEverywherePart(*scene, drawn, truth, tolerance) : 0.0,
        !warnings.Messages().empty(), blend == Mapper::MAXIMUM_INTENSITY_BLEND });
    }
  }
}

void ExpectToleranceOrWarning(const std::vector<ExtremeScene>& scenes)
{
  constexpr double tolerance = 255.0 / 64.0;
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const ExtremeScene& extreme : scenes)
  {
    JudgeEveryBlend(extreme, window,
      [](const Judged& judged)
      {
        EXPECT_TRUE(judged.warned || judged.error.percentile999 <= tolerance)
          << judged.error.percentile999;
        // In one ray of a thousand, a maximum may be the second highest peak.
        const double accepted = judged.extreme ? 0.001 : 0.0;
        EXPECT_TRUE(judged.warned || judged.offEverywherePart <= accepted ||
          judged.error.largest <= 2.0 * tolerance)
          << judged.error.largest << ", " << judged.offEverywherePart;
      });
  }
}

}

TEST(Extremes, OfMaterialsKeepTheErrorToleranceOrWarn)
{
  ExpectToleranceOrWarning(ExtremeMaterials());
}

TEST(Extremes, OfScalarsKeepTheErrorToleranceOrWarn)
{
  ExpectToleranceOrWarning(ExtremeScalars());
}

TEST(Extremes, OfShapesKeepTheErrorToleranceOrWarn)
{
  ExpectToleranceOrWarning(ThinShapes());
  ExpectToleranceOrWarning(ExtremeShapes());
}

TEST(Extremes, ViewsKeepTheErrorToleranceOrWarn)
{
  ExpectToleranceOrWarning(ExtremeViews());
}

TEST(Extremes, HardSurfacesAreWrongOnlyWhereRaysGrazeThem)
{
  // At such a silhouette, a pixel is either entirely right or entirely wrong, and then equals that
  // of a neighbouring ray.
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const ExtremeScene& extreme : HardSurfaces())
  {
    JudgeEveryBlend(extreme, window,
      [](const Judged& judged)
      {
        EXPECT_TRUE(judged.warned || judged.offPart < 0.005) << judged.offPart;
        EXPECT_TRUE(judged.warned || judged.offEverywherePart == 0.0) << judged.offEverywherePart;
      });
  }
}

TEST(Extremes, ThousandsOfStepsKeepTheirPlaces)
{
  // A position summed up from so many float steps would be off by a fraction of a voxel, and the
  // image by 4/255 for each hundredth.
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const ExtremeScene& extreme : ExtremesWithoutTolerance())
  {
    if (extreme.name != "EighteenThousandSteps" && extreme.name != "StepOf1e-4Voxels")
    {
      continue;
    }
    SCOPED_TRACE(extreme.name);
    const auto scene = MapperSceneOf(extreme, 16, window);
    for (int acceleration : { Mapper::Off, Mapper::OpticalField })
    {
      for (bool shaded : { false, true })
      {
        scene->mapper->SetAccelerationMode(acceleration);
        scene->volume->GetProperty()->SetShade(shaded);
        const ExpectedVtkErrors fewerOfLitOnes;
        const varimarch::ImageError error = scene->Error();
        EXPECT_EQ(fewerOfLitOnes.Messages().empty(), !shaded);
        EXPECT_LT(error.largest, 2.0) << Describe(scene->mapper) << ", shaded " << shaded;
      }
    }
  }
}

TEST(Extremes, ASampleDistanceTooShortToEndIsLengthenedWithAWarning)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const ExtremeScene& extreme : ExtremesWithoutTolerance())
  {
    if (extreme.name != "StepOf1e-30")
    {
      continue;
    }
    const auto scene = MapperSceneOf(extreme, 16, window);
    ExpectedVtkErrors warnings;
    EXPECT_LT(scene->Error().largest, 0.5);
    EXPECT_NE(warnings.Text().find("is too short for this volume"), std::string::npos);
  }
}

namespace
{

// One of 10 x 9 x 8 voxels has the value; the others range from 0 to 1.
vtkSmartPointer<vtkImageData> FloatsWith(double value)
{
  auto floats = vtkSmartPointer<vtkImageData>::New();
  floats->SetDimensions(10, 9, 8);
  floats->SetOrigin(-4.5, -4.0, -3.5);
  floats->AllocateScalars(VTK_FLOAT, 1);
  vtkDataArray* const scalars = floats->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, double(i % 10) / 9.0);
  }
  floats->SetScalarComponentFromDouble(5, 3, 4, 0, value);
  return floats;
}

}

TEST(Extremes, ANanColorFillsTheCellsThatTouchSuchAVoxelAndNothingElse)
{
  MapperScene scene(FloatsWith(std::nan("")), 64);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.mapper->SetNanColor(0.2, 1.0, 0.4);
  scene.mapper->SetNanOpacity(1.0);
  const std::vector<float> cellsAlone = scene.Truth();

  scene.opacities->AddPoint(1.0, 0.3);
  for (int blend : { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND,
         Mapper::MINIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND })
  {
    scene.mapper->SetBlendMode(blend);
    scene.mapper->SetNanOpacity(0.0);
    const std::vector<float> clear = scene.Draw();
    scene.mapper->SetNanOpacity(1.0);
    const std::vector<float> filled = scene.Draw();
    int filledPixels = 0;
    for (std::size_t pixel = 0; pixel < filled.size(); pixel += 4)
    {
      const bool meetsCells = blend == Mapper::COMPOSITE_BLEND && cellsAlone[pixel + 3] > 0.0f;
      filledPixels += meetsCells;
      const bool same = std::equal(&filled[pixel], &filled[pixel] + 4, &clear[pixel]);
      EXPECT_EQ(same, !meetsCells) << "pixel " << pixel / 4 << ", " << Describe(scene.mapper);
      EXPECT_TRUE(!meetsCells || filled[pixel + 3] == 1.0f) << "pixel " << pixel / 4;
    }
    EXPECT_EQ(filledPixels > 50, blend == Mapper::COMPOSITE_BLEND);
  }
}

TEST(Extremes, VoxelsThatAreNotFiniteCostOtherVolumesNothing)
{
  using Parts = std::vector<std::string>;
  const auto partsOf = [](double value, double nanOpacity)
  {
    MapperScene scene(FloatsWith(value), 16);
    scene.mapper->SetNanOpacity(nanOpacity);
    scene.Draw();
    Parts parts = scene.ShaderParts();
    parts.erase(
      std::remove_if(parts.begin(), parts.end(),
        [](const std::string& part) { return part.find("Gaps/") != 0 && part.find("Fill/") != 0; }),
      parts.end());
    return parts;
  };
  EXPECT_EQ(partsOf(1.0, 0.0), Parts{ "Gaps/None.glsl" });
  EXPECT_EQ(partsOf(1.0, 0.5), Parts{ "Gaps/None.glsl" });
  EXPECT_EQ(partsOf(std::nan(""), 0.0), (Parts{ "Fill/None.glsl", "Gaps/Cells.glsl" }));
  EXPECT_EQ(partsOf(std::nan(""), 0.5), (Parts{ "Fill/Color.glsl", "Gaps/Cells.glsl" }));
}
