#include "Scene/Slices/CurvedPicture.h"

#include "Scene/Model/WorldVector.h"

#include <vtkImageData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr int PiecesPerSpan = 32; // straight pieces between two given points

// The pieces between two given points need coordinates that differ, so the points must not be so
// close that few digits of theirs do.
constexpr double SmallestSpan = 1e-9;
constexpr double Rounding = 1e-13; // differences that say nothing about a direction

/// @param smallest  distance that does not count, as a part of the coordinates
bool AreDistinct(const glm::dvec3& a, const glm::dvec3& b, double smallest)
{
  return glm::distance(a, b) > smallest * (1.0 + glm::length(a));
}

std::vector<glm::dvec3> DistinctPoints(const std::vector<std::array<double, 3>>& pointsMm)
{
  std::vector<glm::dvec3> points;
  for (const std::array<double, 3>& point : pointsMm)
  {
    if (points.empty() || AreDistinct(points.back(), VectorOf(point), SmallestSpan))
    {
      points.push_back(VectorOf(point));
    }
  }
  return points;
}

/// The piece of a centripetal Catmull-Rom spline between the second and the third of four points,
/// by the pyramid of Barry and Goldman.
class SplineSpan
{
public:
  explicit SplineSpan(const std::array<glm::dvec3, 4>& points)
    : points(points)
  {
    for (int i = 1; i < 4; ++i)
    {
      this->knots[i] = this->knots[i - 1] + std::sqrt(glm::distance(points[i - 1], points[i]));
    }
  }

  /// @param part  0 is the second point, 1 the third
  glm::dvec3 At(double part) const
  {
    const double t = glm::mix(this->knots[1], this->knots[2], part);
    std::array<glm::dvec3, 4> level = this->points;
    for (int span = 1; span < 3; ++span)
    {
      for (int i = 0; i + span < 4; ++i)
      {
        level[i] = this->Between(level[i], level[i + 1], { i, i + span }, t);
      }
    }
    return this->Between(level[0], level[1], { 1, 2 }, t);
  }

private:
  glm::dvec3 Between(
    const glm::dvec3& a, const glm::dvec3& b, const std::array<int, 2>& ends, double t) const
  {
    const double first = this->knots[ends[0]];
    return glm::mix(a, b, (t - first) / (this->knots[ends[1]] - first));
  }

  std::array<glm::dvec3, 4> points;
  std::array<double, 4> knots = {};
};

// The direction perpendicular to a curve that is nearest to the head, or to the front where the
// curve goes along the body.
glm::dvec3 FirstAcross(const glm::dvec3& along)
{
  constexpr double MostCosine = 0.9;
  const glm::dvec3 head(0.0, 0.0, 1.0);
  const glm::dvec3 front(0.0, -1.0, 0.0);
  const glm::dvec3 wanted = std::abs(glm::dot(along, head)) > MostCosine ? front : head;
  return glm::normalize(wanted - glm::dot(wanted, along) * along);
}

}

CurvePath::CurvePath(const std::vector<std::array<double, 3>>& pointsMm)
{
  const std::vector<glm::dvec3> given = DistinctPoints(pointsMm);
  this->points = { given.front() };
  const int last = int(given.size()) - 1;
  // The points beyond the ends mirror their neighbours.
  const auto pointAt = [&](int i)
  {
    return i < 0 ? 2.0 * given[0] - given[1]
      : i > last ? 2.0 * given[last] - given[last - 1]
                 : given[i];
  };
  for (int i = 0; i < last; ++i)
  {
    const SplineSpan span({ pointAt(i - 1), pointAt(i), pointAt(i + 1), pointAt(i + 2) });
    for (int piece = 1; piece <= PiecesPerSpan; ++piece)
    {
      this->points.push_back(span.At(double(piece) / PiecesPerSpan));
    }
  }
  this->FindLengths();
  if (this->LengthMm() > 0.0)
  {
    this->FindDirections();
  }
}

// The chord has a length unless the curve is closed.
CurvePath CurvePath::Stretched(double turnDegrees) const
{
  const glm::dvec3 chord = this->points.back() - this->points.front();
  const bool isOpen = AreDistinct(this->points.front(), this->points.back(), SmallestSpan);
  const glm::dvec3 axis = isOpen ? glm::normalize(chord) : this->along.front();
  const glm::dvec3 across = glm::angleAxis(glm::radians(turnDegrees), axis) * FirstAcross(axis);
  double least = glm::dot(this->points.front(), across);
  double most = least;
  for (const glm::dvec3& point : this->points)
  {
    least = std::min(least, glm::dot(point, across));
    most = std::max(most, glm::dot(point, across));
  }
  CurvePath stretched;
  for (const glm::dvec3& point : this->points)
  {
    const double height = glm::dot(point, across) - 0.5 * (least + most);
    stretched.points.push_back(point - height * across);
  }
  stretched.FindLengths();
  stretched.FindAlong();
  stretched.across.assign(stretched.points.size(), across);
  return stretched;
}

void CurvePath::FindLengths()
{
  this->lengthsMm = { 0.0 };
  for (std::size_t i = 1; i < this->points.size(); ++i)
  {
    this->lengthsMm.push_back(
      this->lengthsMm.back() + glm::distance(this->points[i - 1], this->points[i]));
  }
}

// A curve may return the way it came, and a stretched one may rest, but for rounding.
void CurvePath::FindAlong()
{
  const int last = int(this->points.size()) - 1;
  const auto before = [&](int i) { return this->points[std::max(i - 1, 0)]; };
  const auto behind = [&](int i) { return this->points[std::min(i + 1, last)]; };
  const auto moves = [&](int i) { return AreDistinct(before(i), behind(i), Rounding); };
  int first = 0;
  while (first < last && !moves(first))
  {
    ++first;
  }
  for (int i = 0; i <= last; ++i)
  {
    const int at = std::max(i, first);
    this->along.push_back(
      at == first || moves(at) ? glm::normalize(behind(at) - before(at)) : this->along.back());
  }
}

// The direction across is carried on by two reflections (Wang, Jüttler, Zheng and Liu, "Computation
// of rotation minimizing frames", 2008): at the plane between two points, then at the one between
// the reflected and the true direction along the curve.
void CurvePath::FindDirections()
{
  this->FindAlong();
  const int last = int(this->points.size()) - 1;
  this->across = { FirstAcross(this->along[0]) };
  const auto reflected = [](const glm::dvec3& vector, const glm::dvec3& normal)
  {
    const double square = glm::dot(normal, normal);
    return square > 0.0 ? vector - 2.0 / square * glm::dot(normal, vector) * normal : vector;
  };
  for (int i = 0; i < last; ++i)
  {
    const glm::dvec3 step = this->points[i + 1] - this->points[i];
    const glm::dvec3 second = this->along[i + 1] - reflected(this->along[i], step);
    const glm::dvec3 carried = reflected(reflected(this->across[i], step), second);
    const glm::dvec3& direction = this->along[i + 1];
    this->across.push_back(glm::normalize(carried - glm::dot(carried, direction) * direction));
  }
}

CurvePath::Place CurvePath::At(double distanceMm, double turnDegrees) const
{
  const auto upper =
    std::upper_bound(this->lengthsMm.begin() + 1, this->lengthsMm.end() - 1, distanceMm);
  const std::size_t i = std::size_t(upper - this->lengthsMm.begin()) - 1;
  const double spanMm = this->lengthsMm[i + 1] - this->lengthsMm[i];
  const double part =
    spanMm > 0.0 ? std::clamp((distanceMm - this->lengthsMm[i]) / spanMm, 0.0, 1.0) : 0.0;
  const auto between = [&](const std::vector<glm::dvec3>& of)
  { return glm::mix(of[i], of[i + 1], part); };
  const glm::dvec3 mixedAlong = between(this->along);
  const bool turnsBack = glm::length(mixedAlong) == 0.0;
  const glm::dvec3 direction = turnsBack ? this->along[i] : glm::normalize(mixedAlong);
  const glm::dvec3 mixed = between(this->across);
  const glm::dvec3 straight = glm::normalize(mixed - glm::dot(mixed, direction) * direction);
  return { between(this->points), direction,
    glm::angleAxis(glm::radians(turnDegrees), direction) * straight };
}

double CurvePath::NearestMm(const glm::dvec3& pointMm) const
{
  double nearest = 0.0;
  double least = glm::distance(this->points[0], pointMm);
  for (std::size_t i = 1; i < this->points.size(); ++i)
  {
    const glm::dvec3 step = this->points[i] - this->points[i - 1];
    const double square = glm::dot(step, step);
    const double part = square > 0.0
      ? std::clamp(glm::dot(pointMm - this->points[i - 1], step) / square, 0.0, 1.0)
      : 0.0;
    const double distance = glm::distance(this->points[i - 1] + part * step, pointMm);
    if (distance < least)
    {
      least = distance;
      nearest = this->lengthsMm[i - 1] + part * std::sqrt(square);
    }
  }
  return nearest;
}

namespace
{

// Rows begin on the side that `across` points to.
double OffsetMm(const CurvedRequest& request, double row)
{
  return request.mmPerPixel * (0.5 * request.height - row);
}

}

std::vector<std::uint8_t> CurvedPicture(
  vtkImageData* image, const CurvePath& path, const CurvedRequest& request)
{
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height);
  const SlabSampler sampler(image, request.look);
  const auto drawColumn = [&](int column)
  {
    const double distanceMm = request.mmPerPixel * (column + 0.5);
    if (distanceMm > path.LengthMm())
    {
      return;
    }
    const CurvePath::Place place = path.At(distanceMm, request.turnDegrees);
    const glm::dvec3 middle = VoxelIndexOf(place.pointMm, image);
    const auto step = [&](const glm::dvec3& stepMm)
    { return VoxelIndexOf(place.pointMm + stepMm, image) - middle; };
    const glm::dvec3 perMm = step(place.across);
    const glm::dvec3 through = step(sampler.StepMm() * glm::cross(place.along, place.across));
    for (int row = 0; row < request.height; ++row)
    {
      pixels[std::size_t(row) * request.width + column] =
        sampler.GrayAt(middle + OffsetMm(request, row + 0.5) * perMm, through);
    }
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, request.width),
    [&](const tbb::blocked_range<int>& columns)
    {
      for (int column = columns.begin(); column != columns.end(); ++column)
      {
        drawColumn(column);
      }
    });
  return pixels;
}

glm::dvec3 PointInCurved(
  const CurvePath& path, const CurvedRequest& request, double column, double row)
{
  const CurvePath::Place place = path.At(request.mmPerPixel * column, request.turnDegrees);
  return place.pointMm + OffsetMm(request, row) * place.across;
}

}
