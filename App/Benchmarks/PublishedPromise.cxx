#include "PublishedPromise.h"

#include "Core/Fields/VariationField.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

namespace varimarch
{

namespace
{

constexpr int Jumps = 200000;
constexpr double StepVoxels = 0.25; // distance of the values that a jump is compared with

using Grid = ScalarGrid<unsigned char>;

double MeanOf(const VariationField& field)
{
  return std::accumulate(field.voxels.begin(), field.voxels.end(), 0.0) /
    double(field.voxels.size());
}

// The largest difference between the value at the beginning of a jump and those on its way.
double LargestOn(const Grid& grid, glm::dvec3 from, glm::dvec3 direction, double length)
{
  const glm::dvec3 last(grid.Dimensions() - 1);
  const double value = grid.Value(from);
  double largest = 0.0;
  for (double t = StepVoxels; t < length; t += StepVoxels)
  {
    const glm::dvec3 place = from + t * direction;
    if (glm::clamp(place, glm::dvec3(0.0), last) != place)
    {
      break; // the ray leaves the volume
    }
    largest = std::max(largest, std::abs(grid.Value(place) - value));
  }
  return largest;
}

void TryAllJumps(
  const Grid& grid, const VariationField& field, double tolerance, PublishedPromise& found)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::normal_distribution<double> normal;
  const glm::ivec3 count = grid.Dimensions();
  int longJumps = 0;
  int broken = 0;
  for (int i = 0; i < Jumps; ++i)
  {
    const glm::dvec3 from =
      glm::dvec3(part(random), part(random), part(random)) * glm::dvec3(count - 1);
    const glm::dvec3 direction =
      glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::ivec3 voxel(from + 0.5);
    const int distance =
      field.voxels[(std::size_t(voxel.z) * count.y + voxel.y) * count.x + voxel.x];
    if (distance < 2)
    {
      continue;
    }
    const double largest = LargestOn(grid, from, direction, distance);
    ++longJumps;
    broken += largest >= tolerance;
    found.largest = std::max(found.largest, largest);
  }
  found.longJumps = longJumps / double(Jumps);
  found.brokenJumps = longJumps > 0 ? broken / double(longJumps) : 0.0;
}

}

PublishedPromise TryJumps(vtkImageData* bytes, double tolerance)
{
  const int* const size = bytes->GetDimensions();
  const Grid grid(
    static_cast<unsigned char*>(bytes->GetScalarPointer()), { size[0], size[1], size[2] });
  PublishedPromise found = {};
  const auto start = std::chrono::steady_clock::now();
  const VariationField field = BuildVariationField(grid, tolerance, VoxelDistance::Euclidean);
  found.buildSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  found.meanEuclidean = MeanOf(field);
  found.meanChebyshev = MeanOf(BuildVariationField(grid, tolerance, VoxelDistance::Chebyshev));
  TryAllJumps(grid, field, tolerance, found);
  return found;
}

}
