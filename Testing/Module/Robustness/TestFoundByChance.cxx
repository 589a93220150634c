// Kinds of faults that random scenes have shown, each in a scene that shows nothing else.

#include "Module/Scenes/ComponentVolumes.h"
#include "Stages/ExtremeScenes.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace varimarch::extreme;
using Mapper = vtkVariationFieldVolumeMapper;

TEST(FoundByChance, ExtremesThatLookTheSameForAllValuesAreDrawn)
{
  for (const auto& image :
    { Constant(0.0, VTK_UNSIGNED_CHAR), Lumpy(SmallBox, VTK_UNSIGNED_CHAR, 0.0, 6.0),
      Lumpy(SmallBox, VTK_UNSIGNED_CHAR, 0.0, 255.0), Constant(-3e-30) })
  {
    MapperScene scene(image(), 9);
    Opacities({ { -1.0, 0.3 } })(scene);
    SCOPED_TRACE(testing::Message()
      << scene.image->GetScalarRange()[0] << " to " << scene.image->GetScalarRange()[1]);
    for (const int blend : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::MINIMUM_INTENSITY_BLEND })
    {
      scene.mapper->SetBlendMode(blend);
      EXPECT_NEAR(scene.MiddlePixel()[3], 0.3, 1e-3) << "blend mode " << blend;
    }
  }
}

namespace
{

// A slab of less than half a voxel, from z = 4.3 on.
const std::vector<std::function<void(MapperScene&)>> ThinCuts = {
  [](MapperScene& scene)
  {
    scene.mapper->CroppingOn();
    scene.mapper->SetCroppingRegionPlanes(-100.0, 100.0, -100.0, 100.0, 4.3, 4.7);
  },
  [](MapperScene& scene)
  {
    constexpr int BetweenPlanesOfZ = 0x3fe00;
    scene.mapper->CroppingOn();
    scene.mapper->SetCroppingRegionPlanes(3.0, 5.0, 3.0, 5.0, 4.3, 4.7);
    scene.mapper->SetCroppingRegionFlags(BetweenPlanesOfZ);
  },
  [](MapperScene& scene)
  {
    for (const double side : { -1.0, 1.0 })
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.01 * side, 0.02 * side, side);
      plane->SetOrigin(4.0, 4.0, 4.5 - 0.2 * side);
      scene.mapper->AddClippingPlane(plane);
    }
  },
};

}

// Four samples fit into a thin piece, however long their distance. Trial images of long distances
// are then all the same.
TEST(FoundByChance, TheErrorToleranceIsKeptInThinPieces)
{
  constexpr double Tolerance = 1.0 / 255.0;
  for (std::size_t i = 0; i < ThinCuts.size(); ++i)
  {
    SCOPED_TRACE(i);
    MapperScene scene(ImageOf(VTK_FLOAT, 2,
      [](glm::ivec3 voxel, int component)
      { return 5.0 * voxel.x + (component == 0 ? 40.0 : 20.0) * (voxel.z - 4); },
      { 9, 9, 9 }));
    LookAlongZ(scene);
    scene.renderer->GetActiveCamera()->SetParallelScale(5.0);
    SetLook(scene.volume->GetProperty(), 0, { glm::dvec3(0.2, 0.5, 1.0), 0.0, 80.0, 0.6 });
    SetLook(scene.volume->GetProperty(), 1, { glm::dvec3(1.0, 0.4, 0.3), 0.0, 80.0, 0.4 });
    ThinCuts[i](scene);
    scene.mapper->SetBlendModeToMaximumIntensity();
    scene.mapper->SetErrorTolerance(Tolerance);
    std::vector<float> truth = scene.Truth();
    const std::vector<float> ofSecond = scene.Truth(1e-5, 1);
    std::transform(truth.begin(), truth.end(), ofSecond.begin(), truth.begin(), std::plus<>());
    const std::vector<float> drawn = scene.Draw();
    EXPECT_LE(varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999,
      255.0 * Tolerance);
    EXPECT_LT(scene.mapper->GetUsedSampleDistance(), 0.4 / 7.0) << "samples across the slab";
  }
}

// The table of a pre-integration has at most 1024 values, none of them between such nodes. Its
// error is the same at all sample distances, so that only samples can keep the tolerance.
TEST(FoundByChance, NodesWithinAThousandthOfTheRangeAreSampled)
{
  constexpr double Tolerance = 1.0 / 128.0;
  MapperScene scene(ImageOf(VTK_FLOAT, 1,
                      [](glm::ivec3 voxel, int)
                      {
                        const bool isFar = std::max({ voxel.x, voxel.y, voxel.z }) < 2;
                        const double part = 0.5 +
                          0.5 * std::sin(0.7 * voxel.x + 0.5 * voxel.y) * std::cos(0.6 * voxel.z);
                        return isFar ? 1e6 : 900.0 * part;
                      },
                      { 11, 9, 10 }),
    48);
  scene.volume->GetProperty()->ShadeOff();
  Opacities({ { 100.0, 0.0 }, { 300.0, 0.25 }, { 500.0, 0.003 }, { 700.0, 0.15 }, { 900.0, 0.28 },
              { 1e6, 0.2 } },
    0.0, 900.0)(scene);
  scene.mapper->SetErrorTolerance(Tolerance);
  for (const int rule : { Mapper::Automatic, Mapper::PreIntegrated })
  {
    SCOPED_TRACE(rule == Mapper::Automatic ? "automatic" : "pre-integrated");
    scene.mapper->SetIntegrationRule(rule);
    const ExpectedVtkErrors warnings;
    const double error = scene.Error().percentile999 / 255.0;
    const bool isSampled = rule == Mapper::Automatic;
    EXPECT_EQ(error <= Tolerance, isSampled) << error;
    EXPECT_EQ(scene.mapper->GetErrorToleranceIsKept(), isSampled);
  }
}
