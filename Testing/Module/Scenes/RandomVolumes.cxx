#include "Module/Scenes/RandomScenes.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkUniformGrid.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>
#include <sstream>

using varimarch::ValueRange;

namespace
{

const std::vector<int> IntegerTypes = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG };

bool IsFloating(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

// The values that a type tells apart by a thousandth of the range or, for integers, by 1, and that
// doubles represent exactly.
ValueRange LimitsOf(int type)
{
  constexpr double MostWhole = 9e15;
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  return ValueRange{ array->GetDataTypeMin(), array->GetDataTypeMax() }.And(
    IsFloating(type) ? ValueRange{ -3e37, 3e37 } : ValueRange{ -MostWhole, MostWhole });
}

ValueRange RandomFloatingValues(int type, Dice& dice)
{
  const double scale = dice.OneOf<double>({ 1.0, 1.0, 255.0, 3000.0, 1e-30, 1e30, 1e-5, 1e9 });
  const double mostOffset = type == VTK_DOUBLE ? 1e8 : 1e3;
  const double offset = dice.Chance(0.6)
    ? 0.0
    : dice.OneOf<double>({ -1.0, 1.0 }) * dice.InOrdersBetween(0.1, mostOffset);
  const double first = scale * (offset - dice.OneOf<double>({ 0.0, 0.0, 0.3, 0.5, 1.0 }));
  return { first, first + scale };
}

ValueRange RandomWholeValues(int type, Dice& dice)
{
  const ValueRange limits = LimitsOf(type);
  if (dice.Chance(0.15))
  {
    return limits;
  }
  double width = std::floor(dice.InOrdersBetween(1.0, std::min(limits.Width(), 1e9)));
  const double first = std::floor(dice.OneOf<double>(
    { 0.0, -0.5 * width, -1024.0, -1e8 + 100.0, 1e7, 30000.0, -1e15, limits.lower, limits.upper }));
  // The reference's doubles interpolate with this part of a value at least.
  width = std::floor(std::clamp(std::abs(first) * 1e-9, width, limits.Width()));
  const double lower = std::clamp(first, limits.lower, limits.upper - width);
  return { lower, lower + width };
}

glm::ivec3 RandomDimensions(Dice& dice)
{
  const auto side = [&]
  {
    const bool isThin = dice.Chance(0.12);
    return isThin ? dice.Whole(1, 2) : dice.Whole(3, 13);
  };
  return { side(), side(), side() };
}

// Numbers in [0, 1] for each position in the unit cube.
using Content = std::function<double(glm::dvec3)>;

Content RandomContent(Dice& dice, std::string& name)
{
  const auto direction = [&]
  { return glm::dvec3(dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0)); };
  name = dice.OneOf<std::string>(
    { "constant", "ramp", "noise", "lumps", "lumps", "balls", "two values" });
  if (name == "constant")
  {
    const double value = dice.OneOf<double>({ 0.0, 1.0, dice.Between(0.0, 1.0) });
    return [value](glm::dvec3) { return value; };
  }
  const glm::dvec3 a = direction();
  const glm::dvec3 b = 6.0 * direction();
  const glm::dvec3 c = 6.0 * direction();
  if (name == "ramp")
  {
    return [a](glm::dvec3 p) { return std::clamp(0.5 + glm::dot(a, p - 0.5), 0.0, 1.0); };
  }
  if (name == "noise")
  {
    return [&dice](glm::dvec3) { return dice.Between(0.0, 1.0); };
  }
  if (name == "lumps")
  {
    return [=](glm::dvec3 p)
    { return 0.5 + 0.25 * std::sin(glm::dot(b, p)) + 0.25 * std::cos(glm::dot(c, p) + 1.0); };
  }
  if (name == "balls")
  {
    const glm::dvec3 center = 0.5 + 0.3 * a;
    return [=](glm::dvec3 p) { return std::max(0.0, 1.0 - 2.0 * glm::length(p - center)); };
  }
  return [&dice](glm::dvec3) { return dice.Chance(0.7) ? 0.0 : 1.0; };
}

void FillImage(vtkImageData* image, int component, const ValueRange& values, const Content& content)
{
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const bool isWhole = !IsFloating(scalars->GetDataType());
  const glm::dvec3 last = glm::max(glm::dvec3(size[0], size[1], size[2]) - 1.0, glm::dvec3(1.0));
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const glm::dvec3 position(
      double(i % size[0]), double(i / size[0] % size[1]), double(i / size[0] / size[1]));
    const double value = values.lower + values.Width() * content(position / last);
    scalars->SetComponent(
      i, component, std::clamp(isWhole ? std::round(value) : value, values.lower, values.upper));
  }
}

// Sets some voxels, one at least, to a value that is far from the others or not finite.
void Puncture(RandomVolume& volume, Dice& dice, std::ostream& text)
{
  vtkDataArray* const scalars = volume.image->GetPointData()->GetScalars();
  const int type = scalars->GetDataType();
  const double infinity = std::numeric_limits<double>::infinity();
  const ValueRange limits = LimitsOf(type);
  double value = dice.OneOf<double>({ -32768.0, limits.lower, limits.upper });
  if (IsFloating(type))
  {
    value = dice.OneOf<double>({ -32768.0, -1e30, 1e30, std::nan(""), infinity, -infinity });
  }
  value = std::isfinite(value) ? std::clamp(value, limits.lower, limits.upper) : value;
  volume.hasGaps = !std::isfinite(value);
  volume.hasFarValues = !volume.hasGaps;
  const vtkIdType count = scalars->GetNumberOfTuples();
  const int punctured = dice.Whole(1, dice.Chance(0.5) ? 3 : 40);
  for (int i = 0; i < punctured; ++i)
  {
    scalars->SetComponent(vtkIdType(dice.Between(0.0, double(count))), 0, value);
  }
  text << ", " << punctured << " voxels of " << value;
}

void Blank(RandomVolume& volume, Dice& dice, std::ostream& text)
{
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(volume.image);
  const bool ofPoints = dice.Chance(0.5);
  const vtkIdType count = ofPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
  const int blanked = dice.Whole(1, 10);
  for (int i = 0; i < blanked; ++i)
  {
    const auto one = vtkIdType(dice.Between(0.0, double(count)));
    ofPoints ? grid->BlankPoint(one) : grid->BlankCell(one);
  }
  volume.image = grid;
  volume.hasGaps = true;
  text << ", " << blanked << " blanked " << (ofPoints ? "points" : "cells");
}

void PlaceImage(vtkImageData* image, Dice& dice, std::ostream& text)
{
  const double unit = dice.Chance(0.8) ? 1.0 : dice.InOrdersBetween(1e-3, 1e3);
  double spacing[3];
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = unit * (dice.Chance(0.1) ? 30.0 : dice.InOrdersBetween(0.4, 2.5));
    origin[axis] = dice.Chance(0.5) ? 0.0 : unit * dice.Between(-100.0, 100.0);
  }
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  text << ", spacing " << spacing[0] << " " << spacing[1] << " " << spacing[2];
  if (dice.Chance(0.3))
  {
    vtkNew<vtkTransform> turn;
    turn->RotateWXYZ(
      dice.Between(0.0, 360.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), 1.0);
    const double flip = dice.OneOf<double>({ 1.0, -1.0 });
    for (int i = 0; i < 9; ++i)
    {
      image->GetDirectionMatrix()->SetElement(
        i / 3, i % 3, flip * turn->GetMatrix()->GetElement(i / 3, i % 3));
    }
    text << ", turned" << (flip < 0.0 ? " and mirrored" : "");
  }
}

}

RandomVolume MakeRandomVolume(Dice& dice, int components)
{
  RandomVolume volume{ vtkSmartPointer<vtkImageData>::New(), {}, false, false, {} };
  std::ostringstream text;
  const int type =
    dice.Chance(0.4) ? dice.OneOf<int>({ VTK_FLOAT, VTK_DOUBLE }) : dice.OneOf(IntegerTypes);
  const glm::ivec3 size = RandomDimensions(dice);
  const int first = dice.Chance(0.8) ? 0 : dice.Whole(-20, 20);
  volume.image->SetExtent(
    first, first + size.x - 1, -first, size.y - 1 - first, first, first + size.z - 1);
  volume.image->AllocateScalars(type, components);
  volume.values =
    IsFloating(type) ? RandomFloatingValues(type, dice) : RandomWholeValues(type, dice);
  text << volume.image->GetScalarTypeAsString() << " " << size.x << "x" << size.y << "x" << size.z;
  for (int component = 0; component < components; ++component)
  {
    std::string name;
    const Content content = RandomContent(dice, name);
    FillImage(volume.image, component, volume.values, content);
    text << ", " << name;
  }
  text << " from " << volume.values.lower << " over " << volume.values.Width();
  PlaceImage(volume.image, dice, text);
  if (components == 1 && dice.Chance(0.25))
  {
    Puncture(volume, dice, text);
  }
  else if (components == 1 && dice.Chance(0.1) && volume.image->GetNumberOfCells() > 1)
  {
    Blank(volume, dice, text);
  }
  volume.description = text.str();
  return volume;
}
