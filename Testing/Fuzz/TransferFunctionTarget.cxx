// Transfer functions, their tables and their bands, against their definitions at single values.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"

#include "Core/Look/OpticalTable.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Core/Look/TransferBands.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr int MostNodes = 6;

/// A part of one whole; its ends often.
double Part(ChosenNumbers& numbers)
{
  const int kind = numbers.Integer(0, 3);
  return kind < 2 ? double(kind) : numbers.Number(0.0, 1.0);
}

NodeShape ChosenShape(ChosenNumbers& numbers)
{
  return numbers.Flag() ? NodeShape() : NodeShape{ Part(numbers), Part(numbers) };
}

/// Values of nodes in ascending order, some of them equal.
std::vector<double> ChosenValues(ChosenNumbers& numbers)
{
  const double scale = numbers.Of({ 1.0, 1e-3, 1e3, 1e-300, 1e30, 1e299 });
  std::vector<double> values(std::size_t(numbers.Integer(0, MostNodes)));
  for (double& value : values)
  {
    value = scale * numbers.Integer(-8, 8);
    value += numbers.Flag() ? scale * numbers.Number(0.0, 1.0) : 0.0;
  }
  std::sort(values.begin(), values.end());
  return values;
}

TransferFunction ChosenFunction(ChosenNumbers& numbers)
{
  std::vector<ColorNode> colors;
  for (const double value : ChosenValues(numbers))
  {
    const glm::dvec3 rgb{ Part(numbers), Part(numbers), Part(numbers) };
    colors.push_back({ value, rgb, ChosenShape(numbers) });
  }
  std::vector<OpacityNode> opacities;
  for (const double value : ChosenValues(numbers))
  {
    opacities.push_back({ value, Part(numbers), ChosenShape(numbers) });
  }
  return { colors, opacities, numbers.Of({ 1.0, 1e-6, 1e6, 2.5 }) };
}

/// ChosenValues at, beside, between and beyond the nodes.
std::vector<double> Probes(const TransferFunction& function, ChosenNumbers& numbers)
{
  std::vector<double> probes = { 0.0, -LargestNumber, LargestNumber };
  const std::vector<double> nodes = function.NodeValues();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double next = nodes[std::min(i + 1, nodes.size() - 1)];
    const double part = numbers.Number(0.0, 1.0);
    for (const double probe : { nodes[i], std::nextafter(nodes[i], -LargestNumber),
           std::nextafter(nodes[i], LargestNumber), nodes[i] + part * (next - nodes[i]) })
    {
      probes.push_back(Limited(probe));
    }
  }
  return probes;
}

void RequireRanges(const TransferFunction& function, double value)
{
  const glm::dvec3 color = function.Color(value);
  Require(glm::all(glm::greaterThanEqual(color, glm::dvec3(0.0))) &&
      glm::all(glm::lessThanEqual(color, glm::dvec3(1.0))),
    "a colour is not in [0, 1]");
  const double opacity = function.Opacity(value);
  Require(opacity >= 0.0 && opacity <= 1.0, "an opacity is not in [0, 1]");
  const double depth = function.Extinction(value) * function.OpacityUnitDistanceMm();
  Require(depth >= 0.0, "an extinction is not >= 0");
  Require(std::abs(-std::expm1(-depth) - opacity) <= 1e-12, "extinction and opacity differ");
}

void RequireBand(const TransferFunction& function, const TransferBands& bands, double value)
{
  const TransferBands::Band& band = bands[bands.BandBelow(value)];
  Require(band.lower < value && value <= band.upper, "a value is not in its band");
  const std::vector<double> nodes = function.NodeValues();
  if (std::binary_search(nodes.begin(), nodes.end(), value) || value == band.upper ||
    band.Kept(value) != value)
  {
    return;
  }
  const double extinction = function.Extinction(value);
  const bool isInvisible = band.kind == TransferBands::Kind::Invisible;
  const bool isOpaque = band.kind == TransferBands::Kind::Opaque;
  Require(!isInvisible || extinction == 0.0, "an invisible band has extinction");
  Require(!isOpaque || std::isinf(extinction), "an opaque band lets light through");
  Require(bands.MayBeVisible(value, value) || extinction == 0.0, "a visible value is hidden");
}

glm::vec4 EntryAt(const OpticalTable& table, double value)
{
  const double last = double(table.entries.size() - 1);
  const double length = table.lastValue - table.firstValue;
  const double part =
    length > 0.0 ? std::clamp((value - table.firstValue) / length, 0.0, 1.0) : 0.0;
  const std::size_t lower = std::min(std::size_t(part * last), table.entries.size() - 2);
  return glm::mix(
    table.entries[lower], table.entries[lower + 1], float(part * last - double(lower)));
}

void RequireTable(const OpticalTable& table, const std::vector<double>& probes)
{
  Require(table.entries.size() >= 2 && table.firstValue <= table.lastValue, "a table is too short");
  for (const glm::vec4& entry : table.entries)
  {
    Require(glm::all(glm::greaterThanEqual(entry, glm::vec4(0.0f))) &&
        glm::all(glm::lessThanEqual(entry, glm::vec4(1.0f, 1.0f, 1.0f, OpaqueExtinction))),
      "an entry of a table is out of range");
  }
  const std::array<double, 2> visible = VisibleValues(table);
  for (const double probe : probes)
  {
    const bool isInside = visible[0] < probe && probe < visible[1];
    Require(
      isInside || EntryAt(table, probe).a == 0.0f, "a value outside the visible ones absorbs");
    const IndexInTable index = IndexOf(table, double(table.entries.size() - 1));
    Require(std::isfinite(probe * index.scale + index.bias) || std::abs(probe) > 1e200,
      "a value has no index");
  }
  for (const glm::vec4& entry : BuildPreIntegratedTable(table, 256).entries)
  {
    Require(glm::all(glm::greaterThanEqual(entry, glm::vec4(0.0f))) && std::isfinite(entry.a),
      "an entry of a pre-integrated table is negative or not finite");
  }
}

bool RunTransferFunction(const std::string& input)
{
  ChosenNumbers numbers(input);
  const TransferFunction function = ChosenFunction(numbers);
  const std::vector<double> probes = Probes(function, numbers);
  const TransferBands bands(function);
  for (const double probe : probes)
  {
    RequireRanges(function, probe);
    RequireBand(function, bands, probe);
  }
  const double a = probes[std::size_t(numbers.Integer(0, int(probes.size()) - 1))];
  const double b = probes[std::size_t(numbers.Integer(0, int(probes.size()) - 1))];
  RequireTable(BuildOpticalTable(function, std::min(a, b), std::max(a, b), 2048), probes);
  return true;
}

}

FuzzTarget TransferFunctionTarget()
{
  return { "transfer-function", RunTransferFunction, [] { return RandomInputs(16, 160); }, {} };
}

}
