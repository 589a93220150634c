// Curves through points, and the volume straightened along them.

#include "Scene/Model/WorldVector.h"
#include "Scene/Slices/CurvedPicture.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double ArcRadiusMm = 40.0;
constexpr double TubeRadiusMm = 4.0;

// Points on a quarter of a circle in the axial plane at z = 5.
std::vector<std::array<double, 3>> QuarterCircle(int count)
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = glm::half_pi<double>() * i / (count - 1);
    points.push_back({ ArcRadiusMm * std::cos(angle), ArcRadiusMm * std::sin(angle), 5.0 });
  }
  return points;
}

// A tube of 200 about that circle in 0, with a bead of 1000 in the middle of the quarter. Voxels of
// 1 mm.
vtkSmartPointer<vtkImageData> CurvedTube()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(60, 60, 31);
  image->SetOrigin(-5.0, -5.0, -10.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* value = static_cast<short*>(image->GetScalarPointer());
  const double h = ArcRadiusMm * std::sqrt(0.5);
  for (int k = 0; k < 31; ++k)
  {
    for (int j = 0; j < 60; ++j)
    {
      for (int i = 0; i < 60; ++i)
      {
        const glm::dvec3 point(i - 5.0, j - 5.0, k - 10.0);
        const double aside = std::hypot(point.x, point.y) - ArcRadiusMm;
        const bool isInTube = std::hypot(aside, point.z - 5.0) <= TubeRadiusMm;
        const bool isInBead = glm::distance(point, glm::dvec3(h, h, 5.0)) <= 2.0;
        *value++ = isInBead ? 1000 : isInTube ? 200 : 0;
      }
    }
  }
  return image;
}

CurvedRequest CurvedRequestOf(double turnDegrees, double slabMm = 0.0)
{
  return { 0.5, 160, 60, turnDegrees, { 200.0, 100.0, slabMm, SlabBlend::Maximum, false } };
}

// First and last bright pixel of a column, in mm from the curve.
std::array<double, 2> BrightSpan(
  const std::vector<std::uint8_t>& picture, const CurvedRequest& request, int column)
{
  std::array<double, 2> span = { 1e9, -1e9 };
  for (int row = 0; row < request.height; ++row)
  {
    if (picture[std::size_t(row) * request.width + column] > 127)
    {
      const double offsetMm = request.mmPerPixel * (0.5 * request.height - row - 0.5);
      span = { std::min(span[0], offsetMm), std::max(span[1], offsetMm) };
    }
  }
  return span;
}

TEST(Curve, HasTheLengthOfTheArcThroughItsPoints)
{
  const CurvePath path(QuarterCircle(9));
  EXPECT_NEAR(path.LengthMm(), glm::half_pi<double>() * ArcRadiusMm, 0.02);
  for (const glm::dvec3& point : path.Points())
  {
    EXPECT_NEAR(std::hypot(point.x, point.y), ArcRadiusMm, 0.12) << "the ends are less curved";
  }
  const CurvePath straight({ { 0, 0, 0 }, { 0, 0, 0 }, { 3, 0, 4 }, { 6, 0, 8 } });
  EXPECT_NEAR(straight.LengthMm(), 10.0, 1e-9) << "a point that is repeated is left out";
  EXPECT_EQ(CurvePath({ { 1, 2, 3 } }).LengthMm(), 0.0);
}

TEST(Curve, PassesThroughItsPointsAtTheirDistances)
{
  const auto points = QuarterCircle(9);
  const CurvePath path(points);
  for (int i = 0; i < 9; ++i)
  {
    const double distanceMm = path.NearestMm(VectorOf(points[i]));
    EXPECT_NEAR(distanceMm, path.LengthMm() * i / 8, 0.02);
    EXPECT_NEAR(glm::distance(path.At(distanceMm, 0.0).pointMm, VectorOf(points[i])), 0.0, 1e-6);
  }
}

TEST(Curve, KeepsTheDirectionAcrossItInAPlane)
{
  const CurvePath path(QuarterCircle(9));
  for (double distanceMm = 0.0; distanceMm < path.LengthMm(); distanceMm += 5.0)
  {
    const CurvePath::Place upright = path.At(distanceMm, 0.0);
    EXPECT_NEAR(upright.across.z, 1.0, 1e-9) << "towards the head";
    EXPECT_NEAR(glm::dot(upright.along, upright.across), 0.0, 1e-9);
    const CurvePath::Place turned = path.At(distanceMm, 90.0);
    const glm::dvec3 outwards = glm::normalize(glm::dvec3(turned.pointMm.x, turned.pointMm.y, 0));
    EXPECT_NEAR(std::abs(glm::dot(turned.across, outwards)), 1.0, 5e-3);
  }
}

TEST(Curve, ReturnsTheWayItCame)
{
  const CurvePath path({ { 0, 0, 0 }, { 10, 0, 0 }, { 0, 0, 0 } });
  // The last is in the middle of the first piece of the way back.
  const double firstPieceMm = glm::distance(path.Points()[32], path.Points()[33]);
  for (const double distanceMm : { 15.0, 10.0, 10.0 + 0.5 * firstPieceMm })
  {
    const CurvePath::Place place = path.At(distanceMm, 0.0);
    EXPECT_TRUE(std::isfinite(place.pointMm.x) && std::isfinite(place.across.x)) << distanceMm;
  }
}

TEST(Curve, LeavesOutPointsThatCoincideButForRounding)
{
  const CurvePath path(
    { { 100, 0, 0 }, { std::nextafter(100.0, 101.0), 0, 0 }, { 110, 0, 0 }, { 120, 0, 0 } });
  EXPECT_NEAR(path.LengthMm(), 20.0, 1e-9);
  EXPECT_NEAR(path.At(5.0, 0.0).along.x, 1.0, 1e-12);
}

TEST(CurvedPicture, ShowsACurvedTubeStraight)
{
  const auto image = CurvedTube();
  const CurvePath path(QuarterCircle(9));
  for (const double turn : { 0.0, 45.0, 90.0, -90.0 })
  {
    const CurvedRequest request = CurvedRequestOf(turn);
    const auto picture = CurvedPicture(image, path, request);
    for (int column = 4; column < 120; ++column)
    {
      const auto [first, last] = BrightSpan(picture, request, column);
      // Voxels of 1 mm and pixels of 0.5 mm.
      EXPECT_NEAR(first, -TubeRadiusMm, 1.0) << turn << ' ' << column;
      EXPECT_NEAR(last, TubeRadiusMm, 1.0) << turn << ' ' << column;
    }
  }
}

TEST(CurvedPicture, HasRightDistancesAlongTheCurve)
{
  const auto image = CurvedTube();
  const CurvePath path(QuarterCircle(9));
  CurvedRequest request = CurvedRequestOf(0.0);
  request.look.window = 10.0;
  request.look.level = 600.0;
  const auto picture = CurvedPicture(image, path, request);
  double sum = 0.0;
  int count = 0;
  for (int pixel = 0; pixel < int(picture.size()); ++pixel)
  {
    if (picture[pixel] > 127)
    {
      sum += request.mmPerPixel * (pixel % request.width + 0.5);
      ++count;
    }
  }
  ASSERT_GT(count, 0);
  EXPECT_NEAR(sum / count, 0.25 * glm::pi<double>() * ArcRadiusMm, 0.3) << "the bead is half way";
  EXPECT_EQ(std::count_if(picture.begin(), picture.end(), [](int gray) { return gray > 0; }),
    std::count(picture.begin(), picture.end(), 255))
    << "nothing else is as bright";
}

TEST(CurvedPicture, IsBlackBeyondTheEndAndThickWithASlab)
{
  const auto image = CurvedTube();
  const CurvePath path(QuarterCircle(9));
  const CurvedRequest thin = CurvedRequestOf(0.0);
  const auto picture = CurvedPicture(image, path, thin);
  const int end = int(path.LengthMm() / thin.mmPerPixel) + 1;
  EXPECT_GT(BrightSpan(picture, thin, end), (std::array<double, 2>{ 1e8, -1e9 }));
  // A cut beside the tube shows it only with a slab that reaches it.
  std::vector<std::array<double, 3>> beside = QuarterCircle(9);
  for (std::array<double, 3>& point : beside)
  {
    point[0] *= 1.2;
    point[1] *= 1.2;
  }
  const CurvePath outer(beside);
  const auto isBright = [&](double slabMm)
  {
    const CurvedRequest request = CurvedRequestOf(0.0, slabMm);
    return BrightSpan(CurvedPicture(image, outer, request), request, 60)[1] > 0.0;
  };
  EXPECT_FALSE(isBright(4.0));
  EXPECT_TRUE(isBright(12.0));
}

TEST(CurvedPicture, KnowsThePointOfAPixel)
{
  const CurvePath path(QuarterCircle(9));
  const glm::dvec3 point = PointInCurved(path, CurvedRequestOf(0.0), 62.8, 20.0);
  const double h = ArcRadiusMm * std::sqrt(0.5);
  EXPECT_NEAR(glm::distance(point, glm::dvec3(h, h, 5.0 + 5.0)), 0.0, 0.1);
}

// A ramp of voxels of 1 mm, in which linear interpolation is exact.
constexpr glm::dvec3 RampPerMm(3.0, 1.0, 2.0);

vtkSmartPointer<vtkImageData> RampOf61()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(61, 61, 61);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 61 * 61 * 61; ++i)
  {
    *value++ = float(glm::dot(RampPerMm, glm::dvec3(i % 61, i / 61 % 61, i / (61 * 61))));
  }
  return image;
}

// Grey of the ramp at a point: 0 is black and 400 white.
double RampGray(const glm::dvec3& pointMm)
{
  return 255.0 * glm::dot(RampPerMm, pointMm) / 400.0;
}

CurvedRequest RampRequest(double mmPerPixel)
{
  return { mmPerPixel, 40, 20, 0.0, { 400.0, 200.0, 0.0, SlabBlend::Maximum, false } };
}

TEST(StretchedCurve, OfAStraightLineIsTheStraightenedOne)
{
  const CurvePath line({ { 10, 12, 30 }, { 30, 27, 30 }, { 50, 42, 30 } });
  const CurvedRequest request = RampRequest(line.LengthMm() / 40.0);
  const auto image = RampOf61();
  for (const double turn : { 0.0, 35.0, 90.0 })
  {
    const CurvePath stretched = line.Stretched(turn);
    EXPECT_NEAR(stretched.LengthMm(), 50.0, 1e-9);
    const auto picture = CurvedPicture(image, stretched, request);
    CurvedRequest turned = request;
    turned.turnDegrees = turn;
    const auto straightened = CurvedPicture(image, line, turned);
    const glm::dvec3 across = line.At(0.0, turn).across;
    for (int pixel = 0; pixel < int(picture.size()); ++pixel)
    {
      const double along = (pixel % 40 + 0.5) * request.mmPerPixel;
      const double up = (10.0 - pixel / 40 - 0.5) * request.mmPerPixel;
      const glm::dvec3 point =
        glm::dvec3(10, 12, 30) + along * glm::dvec3(0.8, 0.6, 0.0) + up * across;
      ASSERT_NEAR(picture[pixel], RampGray(point), 1.0) << turn << ' ' << pixel;
      ASSERT_NEAR(picture[pixel], straightened[pixel], 1.0);
    }
  }
}

// A zigzag towards the head is a plane: its stretched picture is that slice of the ramp.
TEST(StretchedCurve, KeepsTheBendsInItsDirection)
{
  const CurvePath zigzag({ { 12, 20, 20 }, { 20, 20, 34 }, { 32, 20, 20 }, { 45, 20, 34 } });
  const CurvePath stretched = zigzag.Stretched(0.0);
  // The chord rises by 14 on 33, and the direction across it is in the same plane.
  EXPECT_LT(stretched.LengthMm(), zigzag.LengthMm());
  EXPECT_NEAR(stretched.LengthMm(), std::hypot(33.0, 14.0), 1.0) << "it hardly turns back";
  const CurvedRequest request = RampRequest(stretched.LengthMm() / 40.0);
  const auto picture = CurvedPicture(RampOf61(), stretched, request);
  for (int pixel = 0; pixel < int(picture.size()); ++pixel)
  {
    const glm::dvec3 point = PointInCurved(stretched, request, pixel % 40 + 0.5, pixel / 40 + 0.5);
    EXPECT_NEAR(point.y, 20.0, 1e-9);
    ASSERT_NEAR(picture[pixel], RampGray(point), 1.0);
  }
  // Every point of the curve is at its own height over the middle row.
  ASSERT_EQ(stretched.Points().size(), zigzag.Points().size());
  for (std::size_t i = 0; i < zigzag.Points().size(); ++i)
  {
    const glm::dvec3 across = stretched.At(stretched.LengthsMm()[i], 0.0).across;
    const glm::dvec3 moved = zigzag.Points()[i] - stretched.Points()[i];
    EXPECT_NEAR(glm::length(glm::cross(moved, across)), 0.0, 1e-9);
  }
}

// Bends that the direction does not see are stretched: a circle keeps its length.
TEST(StretchedCurve, HasTheLengthOfACurveAcrossItsDirection)
{
  const CurvePath circle(QuarterCircle(9));
  EXPECT_NEAR(circle.Stretched(0.0).LengthMm(), circle.LengthMm(), 1e-9) << "seen from the head";
  EXPECT_NEAR(circle.Stretched(90.0).LengthMm(), ArcRadiusMm * std::sqrt(2.0), 0.1) << "the chord";
}

// It rests where the curve runs along the direction across, here for its first and its last 10 mm.
TEST(StretchedCurve, MayRestAndReturn)
{
  const CurvePath upAndDown({ { 0.1, 0, 0.1 }, { 0.1, 0, 5.1 }, { 0.1, 0, 10.1 }, { 10.1, 0, 10.1 },
    { 10.1, 0, 5.1 }, { 10.1, 0, 0.1 } });
  const CurvePath stretched = upAndDown.Stretched(0.0);
  ASSERT_LT(stretched.LengthMm(), 20.0);
  std::vector<double> distancesMm = stretched.LengthsMm();
  distancesMm.push_back(stretched.LengthMm() + 1.0);
  for (const double distanceMm : distancesMm)
  {
    const CurvePath::Place place = stretched.At(distanceMm, 0.0);
    EXPECT_NEAR(place.pointMm.z, stretched.Points().front().z, 1e-9) << distanceMm;
    EXPECT_NEAR(std::abs(place.along.x), 1.0, 1e-6) << distanceMm;
    EXPECT_NEAR(place.across.z, 1.0, 1e-9) << distanceMm;
  }
}

}
