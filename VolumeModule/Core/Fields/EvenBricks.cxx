#include "Core/Fields/EvenBricks.h"

#include "Core/Fields/StepsUnion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// A range of bricks along an axis, both ends included.
struct Span
{
  int first;
  int last;
};

// The voxel bricks that overlap each brick of the even grid, along one axis.
std::vector<Span> SpansOf(const UnevenAxis& axis, int brickCount, double side)
{
  constexpr double Rounding = 1e-3; // error of a shader's position [voxels]
  std::vector<Span> spans;
  for (int brick = 0; brick < brickCount; ++brick)
  {
    const double lower = axis.VoxelAt(side * brick) - Rounding;
    const double upper = axis.VoxelAt(side * (brick + 1)) + Rounding;
    spans.push_back({ std::clamp(int(std::floor(lower / side)), 0, brickCount - 1),
      std::clamp(int(std::floor(upper / side)), 0, brickCount - 1) });
  }
  return spans;
}

}

BrickRanges EvenBricks(const BrickRanges& ofVoxels, const std::vector<UnevenAxis>& axes)
{
  const glm::ivec3 count = ofVoxels.BrickCount();
  const double side = ofVoxels.Side();
  const std::vector<Span> alongX = SpansOf(axes[0], count.x, side);
  const std::vector<Span> alongY = SpansOf(axes[1], count.y, side);
  const std::vector<Span> alongZ = SpansOf(axes[2], count.z, side);
  const auto indexOf = [&](int x, int y, int z)
  { return x + std::size_t(count.x) * (y + std::size_t(count.y) * z); };
  const auto stepsOf = [&](const Span& spanX, const Span& spanY, const Span& spanZ)
  {
    BrickRanges::Steps steps = ofVoxels[indexOf(spanX.first, spanY.first, spanZ.first)];
    for (int z = spanZ.first; z <= spanZ.last; ++z)
    {
      for (int y = spanY.first; y <= spanY.last; ++y)
      {
        for (int x = spanX.first; x <= spanX.last; ++x)
        {
          steps = Union(steps, ofVoxels[indexOf(x, y, z)]);
        }
      }
    }
    return steps;
  };
  BrickRanges even = ofVoxels;
  tbb::parallel_for(0, count.z,
    [&](int z)
    {
      for (int y = 0; y < count.y; ++y)
      {
        for (int x = 0; x < count.x; ++x)
        {
          even.Set(indexOf(x, y, z), stepsOf(alongX[x], alongY[y], alongZ[z]));
        }
      }
    });
  return even;
}

}
