// Acceleration structures of random volumes, against brute force.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Unit/VariationByBruteForce.h"

#include "Core/Fields/OpticalField.h"
#include "Core/Fields/VisibleBricks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr int MostVoxelsPerSide = 11;

/// A volume of one background with a few other voxels, so that large blocks occur.
template <class Scalar>
OwnedVolume<Scalar> RandomVolume(ChosenNumbers& numbers)
{
  using Limits = std::numeric_limits<Scalar>;
  OwnedVolume<Scalar> volume;
  for (int axis = 0; axis < 3; ++axis)
  {
    volume.dimensions[axis] = numbers.Integer(1, MostVoxelsPerSide);
  }
  volume.voxels.assign(volume.Grid().VoxelCount(), Scalar(numbers.Integer(0, 100)));
  for (int count = numbers.Integer(0, 40); count > 0; --count)
  {
    const int place = numbers.Integer(0, int(volume.voxels.size()) - 1);
    const int kind = numbers.Integer(0, 15);
    volume.voxels[std::size_t(place)] = kind == 0 ? Limits::max()
      : kind == 1                                 ? Limits::lowest()
      : kind == 2                                 ? Limits::quiet_NaN()
      : kind == 3                                 ? Limits::infinity()
                                                  : Scalar(numbers.Integer(0, 100));
  }
  return volume;
}

template <class Action>
void ForEach(glm::ivec3 count, Action action)
{
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    action(glm::ivec3(i % count.x, i / count.x % count.y, i / count.x / count.y), std::size_t(i));
  }
}

template <class Scalar>
void RequireVariation(const OwnedVolume<Scalar>& volume, double tolerance)
{
  const CellField field = BuildCellField(volume.Grid(), tolerance);
  ForEach(field.cellCount,
    [&](glm::ivec3 cell, std::size_t i)
    {
      Require(int(field.cells[i]) == SizeByBruteForce(volume, cell, tolerance),
        "a block of the cell field is not the largest that keeps the tolerance");
    });
  for (const VoxelDistance kind : { VoxelDistance::Euclidean, VoxelDistance::Chebyshev })
  {
    const VariationField distances = BuildVariationField(volume.Grid(), tolerance, kind);
    ForEach(distances.voxelCount,
      [&](glm::ivec3 voxel, std::size_t i)
      {
        Require(int(distances.voxels[i]) == DistanceByBruteForce(volume, voxel, tolerance, kind),
          "a distance of the variation field is not that to the nearest different voxel");
      });
  }
}

/// True if a value absorbs, however its place in the table is rounded.
bool Absorbs(const OpticalTable& table, double value)
{
  constexpr double Rounding = 2e-6;
  const double last = double(table.entries.size() - 1);
  const double length = table.lastValue - table.firstValue;
  const double place = length > 0.0 ? (value - table.firstValue) / length * last : 0.0;
  const auto absorbsAt = [&](double index)
  {
    const double inside = std::clamp(index, 0.0, last);
    const std::size_t below = std::min(std::size_t(inside), table.entries.size() - 2);
    const float part = float(inside - double(below));
    return glm::mix(table.entries[below], table.entries[below + 1], part).a > 0.0f;
  };
  return absorbsAt(place - Rounding) && absorbsAt(place + Rounding);
}

OpticalTable RandomTable(ChosenNumbers& numbers)
{
  std::vector<OpacityNode> nodes;
  double value = -10.0;
  for (int count = numbers.Integer(1, 5); count > 0; --count)
  {
    value += numbers.Number(0.0, 40.0);
    nodes.push_back({ value, numbers.Flag() ? 0.0 : numbers.Number(0.0, 1.0) });
  }
  return BuildOpticalTable(TransferFunction({}, nodes, 1.0), 0.0, 100.0, 1024);
}

/// Requires that no block that may be skipped has a voxel that absorbs.
template <class Scalar>
void RequireOptical(const OwnedVolume<Scalar>& volume, ChosenNumbers& numbers)
{
  const OpticalTable table = RandomTable(numbers);
  constexpr int Side = BrickRanges::CellsPerSide;
  const OpticalField field = BuildOpticalField(BuildBrickRanges(volume.Grid(), 0.0, 100.0), table,
    OpticalTolerance::ForError(numbers.Of({ 0.0, 1.0 / 64.0, 0.5 }), 60.0));
  const Box box =
    VisibleBricks(field).Bounds({ glm::dvec3(0.0), glm::dvec3(volume.Grid().CellCount()) });
  ForEach(volume.dimensions,
    [&](glm::ivec3 voxel, std::size_t i)
    {
      const double value = double(volume.voxels[i]);
      if (!std::isfinite(value) || !Absorbs(table, value))
      {
        return;
      }
      const glm::dvec3 place(voxel);
      Require(
        glm::clamp(place, box.lower, box.upper) == place, "a visible voxel is out of the box");
      ForEach(field.brickCount,
        [&](glm::ivec3 brick, std::size_t b)
        {
          const int radius = int(field.bricks[b]) - OpticalField::Invisible;
          const glm::ivec3 lower = Side * (brick - radius);
          const glm::ivec3 upper = Side * (brick + radius + 1);
          Require(radius < 0 || glm::clamp(voxel, lower, upper) != voxel,
            "a block that is skipped has a visible voxel");
        });
    });
}

template <class Scalar>
bool RunOn(ChosenNumbers& numbers)
{
  const OwnedVolume<Scalar> volume = RandomVolume<Scalar>(numbers);
  const double infinity = std::numeric_limits<double>::infinity();
  RequireVariation(volume, numbers.Of({ 0.0, 0.5, 1.0, 20.0, 1e300, infinity }));
  RequireOptical(volume, numbers);
  return true;
}

bool RunFields(const std::string& input)
{
  ChosenNumbers numbers(input);
  switch (numbers.Integer(0, 4))
  {
    case 0:
      return RunOn<std::uint8_t>(numbers);
    case 1:
      return RunOn<std::int16_t>(numbers);
    case 2:
      return RunOn<std::int32_t>(numbers);
    case 3:
      return RunOn<float>(numbers);
    default:
      return RunOn<double>(numbers);
  }
}

}

FuzzTarget FieldTarget()
{
  return { "fields", RunFields, [] { return RandomInputs(16, 200); }, {} };
}

}
