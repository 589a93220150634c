#include "Frame/FrameMeasures.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Recipe/MaterialRecipe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace varimarch
{

namespace
{

template <class Number>
double SumOf(const Frame& frame, const Number& numberOf)
{
  double sum = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    sum += numberOf(other.geometry);
  }
  return sum;
}

// The least thickness of the pieces that parallel planes cut from a volume.
class ThinnestPiece
{
public:
  ThinnestPiece(const Frame& frame, const Box& grid)
    : box(grid)
    , worldFromNormal(glm::inverse(glm::transpose(frame.geometry.WorldFromGridDirection())))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec4 plane(0.0);
      plane[axis] = 1.0;
      this->Take(plane, this->box.upper[axis] - this->box.lower[axis]);
    }
    this->TakeSlabs(frame.cuts.planesGrid);
    if (frame.cuts.regions)
    {
      this->TakeRegions(frame.cuts.regions->planesGrid);
    }
  }

  double Mm() const { return this->mm; }

private:
  void Take(const glm::dvec4& plane, double thicknessGrid)
  {
    if (thicknessGrid > 0.0)
    {
      const double perMm = glm::length(this->worldFromNormal * glm::dvec3(plane));
      this->mm = std::min(this->mm, thicknessGrid / perMm);
    }
  }

  // Two planes that keep what is between them.
  void TakeSlabs(const std::vector<glm::dvec4>& planes)
  {
    constexpr double Opposite = -0.999;
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (glm::dot(glm::dvec3(planes[i]), glm::dvec3(planes[j])) < Opposite)
        {
          this->Take(planes[i], planes[i].w + planes[j].w);
        }
      }
    }
  }

  void TakeRegions(const std::array<glm::dvec4, 6>& planes)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const glm::dvec4& lower = planes[2 * axis];
      const glm::dvec4& upper = planes[2 * axis + 1];
      this->Take(lower, this->FarthestAbove(-lower));
      this->Take(lower, lower.w - upper.w);
      this->Take(upper, this->FarthestAbove(upper));
    }
  }

  double FarthestAbove(const glm::dvec4& plane) const
  {
    const glm::dvec3 normal(plane);
    const glm::dvec3 corner =
      glm::mix(this->box.lower, this->box.upper, glm::greaterThan(normal, glm::dvec3(0.0)));
    return plane.w + glm::dot(normal, corner);
  }

  Box box;
  glm::dmat3 worldFromNormal;
  double mm = std::numeric_limits<double>::infinity();
};

template <class Number>
double SmallestOf(const Frame& frame, const Number& numberOf)
{
  double smallest = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    smallest = std::min(smallest, numberOf(other.geometry));
  }
  return smallest;
}

}

double SmallestSpacingMm(const Frame& frame)
{
  return SmallestOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.SmallestSpacingMm(); });
}

Box BoxInGrid(const Frame& frame, const Box& data)
{
  return BoxAround(data, glm::inverse(frame.geometry.dataFromGrid));
}

double DiagonalMm(const Frame& frame, const Box& grid)
{
  return glm::length(frame.geometry.WorldFromGridDirection() * (grid.upper - grid.lower));
}

double ThinnestPieceMm(const Frame& frame, const Box& grid)
{
  double thinnest = ThinnestPiece(frame, grid).Mm();
  for (const Frame& other : frame.others)
  {
    thinnest = std::min(thinnest, ThinnestPiece(other, other.cuts.boxGrid).Mm());
  }
  return thinnest;
}

double LongestRayMm(const Frame& frame)
{
  return SumOf(frame, [](const VolumeGeometry& geometry) { return geometry.DiagonalMm(); });
}

double ShortestSampleDistanceMm(const Frame& frame, Marcher marcher)
{
  const double sumMm = SumOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.ShortestSampleDistanceMm(); });
  if (marcher == Marcher::Processor)
  {
    // Its loops have no limit, but with more samples rounding would decide where samples lie.
    constexpr double TimesAsMany = 4.0;
    return sumMm / TimesAsMany;
  }
  // Iterations of a shader's loops per segment: three for one volume; for several volumes two, plus
  // two for each of them. In a lit volume, the loop that searches for visible samples makes pixels
  // wait for each other: it took five iterations in some images, and may take more in others.
  constexpr double IterationsOfOne = 3.0;
  constexpr double IterationsOfLit = 6.0;
  const bool isLit = MarchesMaterial(frame.settings);
  const double volumes = 1.0 + double(frame.others.size());
  const double iterations =
    volumes > 1.0 ? 2.0 + 2.0 * volumes : (isLit ? IterationsOfLit : IterationsOfOne);
  return sumMm * iterations / IterationsOfOne;
}

int MostSegments(const Frame& frame, double sampleDistanceMm)
{
  int most = int(std::ceil(LongestRayMm(frame) / sampleDistanceMm));
  const auto add = [&](const Frame& one)
  { most += one.geometry.dimensions.x + one.geometry.dimensions.y + one.geometry.dimensions.z; };
  add(frame);
  std::for_each(frame.others.begin(), frame.others.end(), add);
  return most;
}

}
