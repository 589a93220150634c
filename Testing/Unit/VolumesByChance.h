#ifndef Varimarch_Testing_Unit_VolumesByChance_h
#define Varimarch_Testing_Unit_VolumesByChance_h

#include "Core/Blocks/BlockLevels.h"
#include "Unit/PacketPictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace varimarch
{

using VoxelAt = std::function<double(const glm::ivec3& place)>;

/// Volumes and functions of every kind, by chance.
class ByChance
{
public:
  explicit ByChance(unsigned seed)
    : random(seed)
  {
  }

  double Number(double lower, double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(this->random);
  }

  /// Waves, noise and steps of any strength.
  VoxelAt Volume()
  {
    const double noise = this->Number(0.0, 1.0) < 0.5 ? 0.0 : this->Number(0.0, 40.0);
    const double wave = this->Number(0.0, 60.0);
    const double step = this->Number(0.0, 1.0) < 0.5 ? 0.0 : this->Number(0.0, 80.0);
    const double wide = this->Number(0.1, 0.8);
    const double middle = this->Number(10.0, 90.0);
    return [=](const glm::ivec3& place)
    {
      const bool isBehind = place.x + place.y > 14;
      return middle + this->Number(-noise, noise) + (isBehind ? step : 0.0) +
        wave * std::sin(wide * place.x) * std::cos(0.7 * wide * place.y + 0.2 * place.z);
    };
  }

  TransferFunction Function()
  {
    std::vector<ColorNode> colors;
    std::vector<OpacityNode> opacities;
    const double most = std::pow(10.0, this->Number(-2.5, 0.0));
    for (const double value : { 0.0, 30.0, 45.0, 60.0, 100.0 })
    {
      colors.push_back(
        { value, { this->Number(0.0, 1.0), this->Number(0.0, 1.0), this->Number(0.0, 1.0) } });
      opacities.push_back({ value, std::max(0.0, this->Number(-0.5 * most, most)) });
    }
    return { colors, opacities, PacketPictures::UnitDistanceMm };
  }

  /// Any levels up to those that there are.
  BlockLevels Levels(BlockLevels levels)
  {
    const double part = this->Number(0.0, 1.0);
    for (BlockLevel& level : levels.ofBlocks)
    {
      const double coarsest = double(level);
      level = this->Number(0.0, 1.0) < part
        ? BlockLevel::Voxels
        : BlockLevel(std::uint8_t(std::ceil(this->Number(0.0, coarsest))));
    }
    return levels;
  }

private:
  std::mt19937 random;
};

}

#endif
