// The polygons, planes and shells that slice-based methods draw, against closed forms.

#include "Benchmarks/Comparison/SliceGeometry.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

const Box UnitCube = { glm::dvec3(0.0), glm::dvec3(1.0) };

glm::dvec4 PlaneAcross(const glm::dvec3& normal, double place)
{
  return { glm::normalize(normal), -place };
}

double AreaOfFan(const Polygon& polygon)
{
  std::vector<glm::vec3> triangles;
  AddFan(polygon, triangles);
  double area = 0.0;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    area += AreaOf({ triangles[i], triangles[i + 1], triangles[i + 2] });
  }
  return area;
}

}

TEST(SlicePolygon, ThroughTheMiddleOfACubeIsARegularHexagon)
{
  const Polygon hexagon =
    SlicePolygon(UnitCube, PlaneAcross({ 1.0, 1.0, 1.0 }, 0.5 * std::sqrt(3.0)));
  ASSERT_EQ(hexagon.size(), 6u);
  EXPECT_NEAR(AreaOf(hexagon), 0.75 * std::sqrt(3.0), 1e-12);
}

TEST(SlicePolygon, NearACornerIsATriangle)
{
  // The plane x + y + z = s cuts a triangle with sides s sqrt(2).
  for (const double s : { 0.1, 0.5, 0.99 })
  {
    const Polygon triangle =
      SlicePolygon(UnitCube, PlaneAcross({ 1.0, 1.0, 1.0 }, s / std::sqrt(3.0)));
    EXPECT_EQ(triangle.size(), 3u);
    EXPECT_NEAR(AreaOf(triangle), 0.5 * std::sqrt(3.0) * s * s, 1e-12);
  }
}

TEST(SlicePolygon, AcrossAnAxisIsAFace)
{
  const Box box = { { 1.0, -2.0, 0.0 }, { 4.0, 5.0, 0.5 } };
  EXPECT_NEAR(AreaOf(SlicePolygon(box, { 0.0, 0.0, 1.0, -0.2 })), 3.0 * 7.0, 1e-12);
  EXPECT_NEAR(AreaOf(SlicePolygon(box, { 0.0, -1.0, 0.0, 1.0 })), 3.0 * 0.5, 1e-12);
}

TEST(SlicePolygon, BesideTheBoxIsEmpty)
{
  EXPECT_TRUE(SlicePolygon(UnitCube, { 1.0, 0.0, 0.0, -1.5 }).empty());
  std::vector<glm::vec3> triangles;
  AddFan({}, triangles);
  EXPECT_TRUE(triangles.empty());
}

TEST(SlicePolygon, IsCoveredByItsFanOnce)
{
  const Polygon polygon = SlicePolygon(UnitCube, PlaneAcross({ 0.9, 0.5, -0.3 }, 0.4));
  EXPECT_GE(polygon.size(), 4u);
  EXPECT_NEAR(AreaOfFan(polygon), AreaOf(polygon), 1e-6); // triangles are floats
}

TEST(SlicePlanes, CutTheBoxIntoLayersThatFillIt)
{
  const glm::dmat4 worldFromGrid = glm::scale(
    glm::rotate(glm::translate(glm::dmat4(1.0), { 7.0, 3.0, -20.0 }), 0.7, { 0.3, 1.0, 0.2 }),
    { 0.5, 1.0, 2.0 });
  const Box boxGrid = { glm::dvec3(0.0), { 20.0, 10.0, 8.0 } };
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
  constexpr double LayerMm = 0.05;
  double volume = 0.0;
  for (const glm::dvec4& plane : PlanesAlong(normal, LayerMm, boxGrid, worldFromGrid))
  {
    Polygon world;
    for (const glm::dvec3& corner : SlicePolygon(boxGrid, plane))
    {
      world.push_back(glm::dvec3(worldFromGrid * glm::dvec4(corner, 1.0)));
      EXPECT_NEAR(
        std::remainder(glm::dot(world.back(), normal) - 0.5 * LayerMm, LayerMm), 0.0, 1e-9);
    }
    volume += LayerMm * AreaOf(world);
  }
  // The midpoint rule over the areas of slices.
  EXPECT_NEAR(volume, 20.0 * 10.0 * 8.0, 0.1);
}

TEST(SlicePlanes, ComeInTheOrderOfTheDirection)
{
  const auto planes = PlanesAlong({ -1.0, 0.0, 0.0 }, 0.25, UnitCube, glm::dmat4(1.0));
  ASSERT_EQ(planes.size(), 4u);
  EXPECT_NEAR(planes.front().w / -planes.front().x, 0.875, 1e-12); // the place of the plane on x
  EXPECT_NEAR(planes.back().w / -planes.back().x, 0.125, 1e-12);
}

TEST(SliceStack, ChangesWhenTheViewIsHalfWayBetweenTwoAxes)
{
  const glm::dmat4 worldFromGrid = glm::scale(glm::dmat4(1.0), { 0.5, 0.5, 3.0 });
  const auto axisAt = [&](double degrees)
  {
    const double angle = glm::radians(degrees);
    return StackAxis({ std::sin(angle), 0.0, -std::cos(angle) }, worldFromGrid);
  };
  EXPECT_EQ(axisAt(44.9), 2);
  EXPECT_EQ(axisAt(45.1), 0);
}

TEST(Shells, AreLayersFromTheEyeOnThatReachTheWholeBox)
{
  const glm::dmat4 worldFromGrid = glm::scale(glm::dmat4(1.0), { 2.0, 1.0, 1.0 });
  const std::vector<double> radii = ShellRadii({ -3.0, 0.5, 0.5 }, 0.5, UnitCube, worldFromGrid);
  const double farthest = glm::length(glm::dvec3(5.0, 0.5, 0.5));
  EXPECT_LE(radii.front() - 0.25, 3.0);
  EXPECT_GE(radii.back() + 0.25, farthest);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    EXPECT_NEAR(radii[i], radii.front() + 0.5 * double(i), 1e-12);
    EXPECT_NEAR(std::remainder(radii[i] - 0.25, 0.5), 0.0, 1e-12);
  }
}
