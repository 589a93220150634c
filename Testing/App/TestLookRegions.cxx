// Transfer functions of value and gradient: their formula, their pictures, and their histogram.

#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/LookRegions.h"
#include "Scene/Looks/ValueGradientHistogram.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace varimarch;

namespace
{

LookRegion Region(RegionShape shape, double opacity = 0.5, double softness = 0.0)
{
  return { shape, { 100.0, 300.0 }, { 10.0, 30.0 }, { 1.0, 0.5, 0.25 }, opacity, softness };
}

// Values rise along x by 10 per voxel, 5 per mm. The mean spacing is 3 mm.
vtkSmartPointer<vtkImageData> Slope()
{
  auto slope = vtkSmartPointer<vtkImageData>::New();
  slope->SetDimensions(17, 16, 16);
  slope->SetSpacing(2.0, 3.0, 4.0);
  slope->AllocateScalars(VTK_SHORT, 1);
  auto* values = static_cast<short*>(slope->GetScalarPointer());
  for (int i = 0; i < 17 * 16 * 16; ++i)
  {
    values[i] = short(10 * (i % 17));
  }
  return slope;
}

// Seen along y, where neither the value nor the gradient varies, and 45 mm deep.
Scene SceneOfSlope(const LookRegion& region)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 0.0, 1.0 } };
  scene.look.shading.enabled = false;
  scene.look.regions = { region };
  scene.camera.view = View::Anterior;
  scene.camera.parallel = true;
  scene.size = { 33, 33 };
  return scene;
}

std::array<float, 4> MiddleOfPicture(const Scene& scene, vtkImageData* image, MapperKind kind)
{
  OffscreenView view(scene, image, kind);
  view.Render(); // VTK's GPU mapper renders its first frame only into the window itself
  const auto picture = view.FloatImage();
  std::array<float, 4> rgba;
  for (int channel = 0; channel < 4; ++channel)
  {
    rgba[channel] = picture->GetScalarComponentAsFloat(16, 16, 0, channel);
  }
  return rgba;
}

}

TEST(LookRegions, ARectangleIsWholeAndAnEllipseTouchesItsSides)
{
  const std::vector<LookRegion> rectangle = { Region(RegionShape::Rectangle) };
  const std::vector<LookRegion> ellipse = { Region(RegionShape::Ellipse) };
  EXPECT_EQ(ColorInRegions(rectangle, 290.0, 29.0).a, 0.5) << "a corner";
  EXPECT_EQ(ColorInRegions(ellipse, 290.0, 29.0).a, 0.0);
  EXPECT_EQ(ColorInRegions(ellipse, 299.0, 20.0).a, 0.5);
  EXPECT_EQ(ColorInRegions(ellipse, 200.0, 10.1).a, 0.5);
  EXPECT_EQ(ColorInRegions(rectangle, 301.0, 20.0).a, 0.0);
  EXPECT_EQ(ColorInRegions(rectangle, 301.0, 20.0).g, 0.5) << "the colour of the nearest";
}

TEST(LookRegions, ASoftEdgeFallsLinearly)
{
  const std::vector<LookRegion> regions = { Region(RegionShape::Rectangle, 0.8, 0.5) };
  EXPECT_NEAR(ColorInRegions(regions, 250.0, 20.0).a, 0.8, 1e-12);
  EXPECT_NEAR(ColorInRegions(regions, 275.0, 20.0).a, 0.4, 1e-12);
  EXPECT_NEAR(ColorInRegions(regions, 200.0, 29.0).a, 0.16, 1e-12);
}

TEST(LookRegions, ARectangleFromTheGradient0HasNoEdgeThere)
{
  LookRegion region = Region(RegionShape::Rectangle, 0.8, 0.5);
  region.gradients = { 0.0, 30.0 };
  EXPECT_NEAR(ColorInRegions({ region }, 200.0, 0.0).a, 0.8, 1e-12);
  EXPECT_NEAR(ColorInRegions({ region }, 200.0, 22.5).a, 0.4, 1e-12);
}

TEST(LookRegions, LaterOnesLieOverEarlierOnes)
{
  LookRegion blue = Region(RegionShape::Rectangle, 0.5);
  blue.rgb = { 0.0, 0.0, 1.0 };
  LookRegion red = Region(RegionShape::Rectangle, 0.25);
  red.rgb = { 1.0, 0.0, 0.0 };
  const glm::dvec4 color = ColorInRegions({ blue, red }, 200.0, 20.0);
  EXPECT_NEAR(color.a, 1.0 - 0.5 * 0.75, 1e-12);
  EXPECT_NEAR(color.r * color.a, 0.25, 1e-12);
  EXPECT_NEAR(color.b * color.a, 0.75 * 0.5, 1e-12);
}

TEST(LookRegions, FollowTheUnitsOfARelativeLook)
{
  const auto slope = Slope();
  Look look;
  look.domain = Domain::Relative;
  look.regions = { { RegionShape::Ellipse, { 0.0, 1.0 }, { 0.0, 0.5 }, { 1, 1, 1 } } };
  const Look resolved = InUnitsOfData(look, slope);
  EXPECT_EQ(resolved.regions[0].values, (std::array{ 0.0, 160.0 }));
  EXPECT_EQ(resolved.regions[0].gradients, (std::array{ 0.0, 80.0 }));
}

TEST(LookRegions, HaveNumbersHoweverWideOrNarrowTheyAre)
{
  for (const double width : { 0.0, 5e-324, 1e308 })
  {
    for (const RegionShape shape : { RegionShape::Rectangle, RegionShape::Ellipse })
    {
      LookRegion region = Region(shape);
      region.values = { -width, width };
      region.gradients = { 0.0, width };
      for (const double number : { 0.0, 1.0, 1e300 })
      {
        const double opacity = ColorInRegions({ region }, number, number).a;
        EXPECT_TRUE(opacity == 0.0 || opacity == 0.5) << width << ", " << number;
      }
    }
  }
}

// 45 mm of a material that takes a fiftieth of the light per mm. VTK's mapper draws it too, but
// with opacities that depend on its steps.
TEST(LookRegions, AreDrawnByValueAndByGradientPerMillimetre)
{
  const auto slope = Slope();
  const double alpha = 1.0 - std::pow(0.98, 45.0);
  constexpr double Tolerance = 2.0 / 255.0;
  for (const MapperKind kind :
    { MapperKind::Varimarch, MapperKind::VarimarchShaders, MapperKind::VtkGpu })
  {
    LookRegion region = { RegionShape::Rectangle, { 20.0, 140.0 }, { 4.0, 6.0 }, { 1.0, 0.5, 0.0 },
      0.02, 0.0 };
    const auto seen = MiddleOfPicture(SceneOfSlope(region), slope, kind);
    EXPECT_GT(seen[3], 0.1f) << int(kind);
    if (IsOurs(kind))
    {
      EXPECT_NEAR(seen[3], alpha, Tolerance) << int(kind);
      EXPECT_NEAR(seen[1], 0.5 * alpha, Tolerance) << int(kind);
    }
    region.gradients = { 6.0, 12.0 };
    EXPECT_EQ(MiddleOfPicture(SceneOfSlope(region), slope, kind)[3], 0.0f) << "too steep";
    region.gradients = { 4.0, 6.0 };
    region.values = { 100.0, 140.0 };
    EXPECT_EQ(MiddleOfPicture(SceneOfSlope(region), slope, kind)[3], 0.0f) << "too large";
  }
}

TEST(LookRegions, GiveWayToTheCurvesWhereTheyCannotBeDrawn)
{
  const auto slope = Slope();
  Scene scene = SceneOfSlope(Region(RegionShape::Rectangle, 0.01));
  EXPECT_TRUE(CanDrawRegions(MapperKind::VtkGpu, Blend::Composite, slope));
  EXPECT_FALSE(CanDrawRegions(MapperKind::VtkCpu, Blend::Composite, slope));
  EXPECT_FALSE(CanDrawRegions(MapperKind::Varimarch, Blend::Additive, slope));
  scene.look.blend = Blend::MaximumIntensity;
  EXPECT_NEAR(MiddleOfPicture(scene, slope, MapperKind::Varimarch)[3], 1.0, 1.0 / 64.0);
}

TEST(LookRegions, ArePickedWhereTheyAreSeen)
{
  const auto slope = Slope();
  Scene scene = SceneOfSlope(
    { RegionShape::Rectangle, { 0.0, 160.0 }, { 4.0, 6.0 }, { 1.0, 1.0, 1.0 }, 0.5, 0.0 });
  const std::array<double, 3> from = { 16.0, -10.0, 30.0 };
  const std::array<double, 3> to = { 16.0, 100.0, 30.0 };
  const auto seen = PointSeen(scene, slope, from, to, nullptr);
  ASSERT_TRUE(seen);
  EXPECT_NEAR((*seen)[1], 1.0, 0.8) << "half of the light is gone after 1 mm";
  scene.look.regions[0].gradients = { 6.0, 7.0 };
  EXPECT_FALSE(PointSeen(scene, slope, from, to, nullptr));
}

TEST(ValueGradientHistogram, CountsEachVoxelAtItsValueAndGradient)
{
  const auto slope = Slope();
  const ValueGradientHistogram histogram = HistogramOf(slope, GradientMagnitudes(slope));
  EXPECT_EQ(histogram.values, (std::array{ 0.0, 160.0 }));
  EXPECT_NEAR(histogram.largestGradient, 5.0, 1e-6);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::int64_t(0)),
    17 * 16 * 16);
  EXPECT_EQ(histogram.CountAt(80.0, 5.0), 16 * 16);
  EXPECT_EQ(histogram.CountAt(0.0, 2.5), 16 * 16) << "a difference to one side only";
  EXPECT_EQ(histogram.CountAt(80.0, 2.5), 0);
  EXPECT_EQ(histogram.CountAt(-1.0, 5.0), 0);
}

TEST(ValueGradientHistogram, ToleratesConstantVolumes)
{
  vtkNew<vtkImageData> constant;
  constant->SetDimensions(4, 4, 4);
  constant->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  constant->GetPointData()->GetScalars()->Fill(7.0);
  const ValueGradientHistogram histogram = HistogramOf(constant, GradientMagnitudes(constant));
  EXPECT_GT(histogram.largestGradient, 0.0);
  EXPECT_EQ(histogram.CountAt(7.0, 0.0), 64);
}
