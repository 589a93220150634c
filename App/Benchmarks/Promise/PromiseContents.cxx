#include "PromiseContents.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch::promise
{

PromiseContent Noise(Dice& dice)
{
  return [&dice](glm::ivec3) { return dice.Between(0.0, 1.0); };
}

PromiseContent Lumps(Dice& dice)
{
  const auto wave = [&]
  { return glm::dvec3(dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0)); };
  const glm::dvec3 a = wave();
  const glm::dvec3 b = wave();
  return [a, b](glm::ivec3 voxel)
  {
    const glm::dvec3 place(voxel);
    return 0.5 + 0.25 * std::sin(glm::dot(a, place)) + 0.25 * std::cos(glm::dot(b, place) + 1.0);
  };
}

PromiseContent Ball(Dice& dice, glm::ivec3 size)
{
  const glm::dvec3 middle = glm::dvec3(size) *
    glm::dvec3(dice.Between(0.35, 0.65), dice.Between(0.35, 0.65), dice.Between(0.35, 0.65));
  const double radius = dice.Between(0.3, 0.6) * std::min({ size.x, size.y, size.z });
  return [=](glm::ivec3 voxel)
  { return std::clamp(1.3 - glm::length(glm::dvec3(voxel) - middle) / radius, 0.0, 1.0); };
}

PromiseContent Sheets(Dice& dice)
{
  const int axis = dice.Whole(0, 2);
  const int across = (axis + 1) % 3;
  const int place = 2 * dice.Whole(2, 4) + 1;
  const int end = dice.Whole(4, 9);
  const double faint = dice.Between(0.1, 0.45);
  return [=](glm::ivec3 voxel)
  { return voxel[axis] == place && voxel[across] < end ? 0.95 : faint; };
}

PromiseContent Wires(Dice& dice)
{
  const int axis = dice.Whole(0, 2);
  const int period = dice.Whole(2, 5);
  const int first = dice.Whole(0, 4);
  const double faint = dice.Between(0.0, 0.4);
  return [=](glm::ivec3 voxel)
  {
    const int one = voxel[(axis + 1) % 3] + first;
    const int other = voxel[(axis + 2) % 3] + 2 * first;
    return one % period == 0 && other % period == 1 ? 0.95 : faint;
  };
}

PromiseContent Walls(Dice& dice)
{
  const int period = dice.Whole(3, 5);
  const int axis = dice.Whole(0, 2);
  const double noise = dice.OneOf<double>({ 0.0, 0.1 });
  return [=, &dice](glm::ivec3 voxel)
  {
    const bool isWall = (voxel[axis] % period == 1 && voxel[(axis + 1) % 3] > 2) ||
      (voxel[(axis + 2) % 3] % 5 == 2 && voxel[axis] > 6);
    return isWall ? 1.0 : noise * dice.Between(0.0, 1.0);
  };
}

PromiseContent Distances(Dice& dice, glm::ivec3 size)
{
  const int axis = dice.Whole(0, 2);
  return [=](glm::ivec3 voxel) { return voxel[axis] / double(size[axis]); };
}

PromiseContent Columns(Dice& dice)
{
  const double between = dice.Between(0.7, 0.8);
  return [=, &dice](glm::ivec3 voxel)
  { return voxel.x % 2 == 1 ? between : dice.Between(0.0, 1.0); };
}

PromiseContent AnyContent(Dice& dice, glm::ivec3 size)
{
  switch (dice.Whole(0, 5))
  {
    case 0:
      return Noise(dice);
    case 1:
      return Ball(dice, size);
    case 2:
      return Sheets(dice);
    case 3:
      return Wires(dice);
    case 4:
      return Walls(dice);
    default:
      return Lumps(dice);
  }
}

glm::ivec3 Size(Dice& dice, int least, int most)
{
  return { dice.Whole(least, most), dice.Whole(least, most), dice.Whole(least, most) };
}

glm::dvec3 Spacing(Dice& dice)
{
  if (dice.Chance(0.4))
  {
    return glm::dvec3(dice.OneOf<double>({ 1.0, 1.0, 0.4, 3.0 }));
  }
  return { dice.Between(0.5, 2.0), dice.Between(0.5, 2.0), dice.Between(0.5, 3.0) };
}

PromiseNodes Ramp(Dice& dice)
{
  const double from = dice.Between(0.0, 0.5);
  return { { from, 0.0 }, { from + dice.Between(0.1, 0.6), dice.Between(0.02, 0.9) } };
}

PromiseNodes ThinPeak(Dice& dice)
{
  const double at = dice.Between(0.2, 0.8);
  const double half = dice.InOrdersBetween(0.004, 0.08);
  return { { at - half, 0.0 }, { at, dice.Between(0.1, 0.95) }, { at + half, 0.0 } };
}

PromiseNodes Steps(Dice& dice)
{
  PromiseNodes nodes;
  double at = dice.Between(0.05, 0.2);
  double before = 0.0;
  const int count = dice.Whole(1, 4);
  for (int i = 0; i < count; ++i)
  {
    const double after = dice.OneOf<double>({ 0.0, dice.Between(0.02, 0.8) });
    nodes.emplace_back(at, before);
    nodes.emplace_back(at, after);
    before = after;
    at += dice.Between(0.05, 0.25);
  }
  return nodes;
}

PromiseNodes Opaque(Dice& dice)
{
  const double from = dice.Between(0.1, 0.4);
  return { { from, 0.0 }, { from + dice.Between(0.05, 0.4), 1.0 } };
}

PromiseNodes Bands(Dice& dice, int voxels)
{
  const double most = dice.OneOf<double>({ 0.1, 0.3, 0.7 });
  PromiseNodes nodes;
  for (int i = 1; i + 1 < voxels; ++i)
  {
    for (const double place : { -0.2, -0.1, 0.1, 0.2 })
    {
      nodes.emplace_back((i + 0.5 + place) / voxels, std::abs(place) < 0.15 ? most : 0.0);
    }
  }
  return nodes;
}

PromiseNodes Dense(Dice& dice)
{
  const double faint = dice.Between(0.02, 0.1);
  return { { 0.05, 0.0 }, { 0.15, faint }, { 0.5, faint }, { 0.7, dice.Between(0.1, 0.4) },
    { 0.9, dice.Between(0.5, 0.95) } };
}

PromiseNodes AnyNodes(Dice& dice)
{
  switch (dice.Whole(0, 4))
  {
    case 0:
      return ThinPeak(dice);
    case 1:
      return Steps(dice);
    case 2:
      return Dense(dice);
    default:
      return Ramp(dice);
  }
}

}
