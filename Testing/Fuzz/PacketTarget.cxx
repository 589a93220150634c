// Packets of rays through random volumes and looks, against the reference integrator.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Unit/PacketPictures.h"

#include "Core/Fields/OpticalField.h"
#include "Core/Quality/ImageError.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Three waves, short ones at most three voxels long.
std::vector<std::int16_t> RandomVoxels(ChosenNumbers& numbers)
{
  std::vector<glm::dvec4> waves;
  for (int wave = 0; wave < 3; ++wave)
  {
    waves.push_back({ numbers.Number(-1.0, 1.0), numbers.Number(-1.0, 1.0),
      numbers.Number(-1.0, 1.0), numbers.Number(0.0, 6.0) });
  }
  const double height = numbers.Number(0.0, 50.0);
  std::vector<std::int16_t> voxels;
  const glm::ivec3 count = PacketPictures::Dimensions;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const glm::dvec4 place(i % count.x, i / count.x % count.y, i / count.x / count.y, 1.0);
    double sum = 0.0;
    for (const glm::dvec4& wave : waves)
    {
      sum += std::sin(glm::dot(wave, place)) / double(waves.size());
    }
    voxels.push_back(std::int16_t(std::lround(50.0 + height * sum)));
  }
  return voxels;
}

/// Nodes at least eight values apart, so that midpoints 0.02 mm apart meet every slope.
TransferFunction RandomLook(ChosenNumbers& numbers)
{
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  for (double value = numbers.Number(0.0, 60.0); value < 100.0; value += numbers.Number(8.0, 40.0))
  {
    colors.push_back(
      { value, { numbers.Number(0, 1), numbers.Number(0, 1), numbers.Number(0, 1) } });
    opacities.push_back({ value, numbers.Flag() ? 0.0 : numbers.Number(0.0, 0.8) });
  }
  return { colors, opacities, PacketPictures::UnitDistanceMm };
}

void ChooseRule(ChosenNumbers& numbers, PacketPictures& pictures)
{
  switch (numbers.Integer(0, 4))
  {
    case 0:
      return pictures.PreIntegrate();
    case 1:
      pictures.LightFromTheEye();
      pictures.scene.rule = PacketRule::MaterialLinear;
      return;
    case 2:
      pictures.scene.rule = PacketRule::Extreme;
      pictures.truth.blend = Blend::MaximumIntensity;
      return;
    case 3:
      pictures.scene.rule = PacketRule::Projection;
      pictures.truth.blend = Blend::AverageIntensity;
      return;
    default:
      pictures.scene.rule = PacketRule::Midpoint;
  }
}

bool RunPackets(const std::string& input)
{
  ChosenNumbers numbers(input);
  const std::vector<std::int16_t> voxels = RandomVoxels(numbers);
  PacketPictures pictures({ voxels, RandomLook(numbers), { 9, 7 } });
  ChooseRule(numbers, pictures);
  const OpticalField field = BuildOpticalField(BuildBrickRanges(pictures.Grid(), 0.0, 100.0),
    pictures.Table(), OpticalTolerance::Nothing(60.0));
  if (numbers.Flag() && pictures.truth.blend == Blend::Composite)
  {
    pictures.scene.steps.grow = true;
    pictures.scene.steps.bricks = field.bricks.data();
    pictures.scene.steps.brickCount = field.brickCount;
    pictures.scene.parameters.cellsPerBrick = float(BrickRanges::CellsPerSide);
  }
  const std::vector<float> truth = pictures.Truth();
  for (const InstructionSet set : InstructionSetsOfProcessor())
  {
    const std::vector<float> image = pictures.March(set);
    Require(std::all_of(image.begin(), image.end(), [](float value) { return value >= 0.0f; }),
      "a pixel is negative or not a number");
    // A grey level: rules of second order at this step differ by less, and mistakes by more.
    const ImageError error = CompareImages(image.data(), truth.data(), truth.size() / 4);
    Require(error.percentile999 < 1.0,
      "packets differ from the reference by " + std::to_string(error.percentile999) + " / 255");
  }
  return true;
}

}

FuzzTarget PacketTarget()
{
  return { "packets", RunPackets, [] { return RandomInputs(16, 160); }, {} };
}

}
