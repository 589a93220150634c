#include "Scene/LookFormats/SlicerProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <vector>

namespace varimarch
{

namespace
{

// A colour node has four numbers.
constexpr std::size_t MostNumbers = 4 * MostLookNodes;

/// The numbers of a text that contains nothing else.
std::vector<double> NumbersOfText(
  const std::string& text, const std::string& file, const char* what)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0.0;
  while (numbers.size() <= MostNumbers && stream >> number)
  {
    numbers.push_back(number);
  }
  stream >> std::ws;
  if (numbers.empty() || !stream.eof())
  {
    FailToReadLook(file,
      std::string("expected numbers for the ") + what + ", found \"" + text.substr(0, 40) + "\"");
  }
  return numbers;
}

/// The numbers of a curve, without the count in front of them.
std::vector<double> NumbersOfCurve(
  const std::string& text, const std::string& file, const char* what, std::size_t perNode)
{
  std::vector<double> numbers = NumbersOfText(text, file, what);
  const double promised = numbers.front();
  numbers.erase(numbers.begin());
  if (promised != double(numbers.size()) || numbers.empty() || numbers.size() % perNode != 0)
  {
    FailToReadLook(file,
      std::string("the ") + what + " promises " +
        std::to_string(std::lround(std::clamp(promised, -1e9, 1e9))) + " numbers, " +
        std::to_string(perNode) + " for each node, the line holds " +
        std::to_string(numbers.size()));
  }
  return numbers;
}

std::vector<OpacityNode> OpacitiesOf(const std::vector<double>& numbers)
{
  std::vector<OpacityNode> nodes;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
  {
    nodes.push_back({ numbers[i], numbers[i + 1] });
  }
  return nodes;
}

void WriteOpacities(std::ostream& text, const std::vector<OpacityNode>& nodes)
{
  text << 2 * nodes.size();
  for (const OpacityNode& node : nodes)
  {
    text << ' ' << node.value << ' ' << node.opacity;
  }
  text << '\n';
}

}

Look LookFromSlicerNumbers(
  const SlicerNumbers& texts, const std::string& file, const LookContext& context)
{
  const auto number = [&](const std::string& text, const char* what)
  { return NumbersOfText(text, file, what).front(); };
  Look look;
  look.shading.enabled = number(texts.shade, "shading") != 0.0;
  look.shading.diffuse = number(texts.diffuse, "diffuse coefficient");
  look.shading.ambient = number(texts.ambient, "ambient coefficient");
  look.shading.specular = number(texts.specular, "specular coefficient");
  look.shading.specularPower = number(texts.specularPower, "specular power");
  look.opacities = OpacitiesOf(NumbersOfCurve(texts.scalarOpacity, file, "scalar opacity", 2));
  TakeGradientOpacities(
    OpacitiesOf(NumbersOfCurve(texts.gradientOpacity, file, "gradient opacity", 2)), context, look);
  const auto colors = NumbersOfCurve(texts.colors, file, "colours", 4);
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    look.colors.push_back({ colors[i], { colors[i + 1], colors[i + 2], colors[i + 3] } });
  }
  return CleanLook(look, file, context);
}

Look LookFromSlicerText(
  const std::string& text, const std::string& file, const LookContext& context)
{
  std::istringstream lines(text);
  std::string interpolation;
  std::getline(lines, interpolation);
  NumbersOfText(interpolation, file, "interpolation");
  SlicerNumbers texts;
  for (std::string* const line : { &texts.shade, &texts.diffuse, &texts.ambient, &texts.specular,
         &texts.specularPower, &texts.scalarOpacity, &texts.gradientOpacity, &texts.colors })
  {
    std::getline(lines, *line);
  }
  return LookFromSlicerNumbers(texts, file, context);
}

std::string SlicerText(const Look& look, const LookContext& context)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "1\n"
       << int(look.shading.enabled) << '\n'
       << look.shading.diffuse << '\n'
       << look.shading.ambient << '\n'
       << look.shading.specular << '\n'
       << look.shading.specularPower << '\n';
  WriteOpacities(text, look.opacities);
  WriteOpacities(text, GradientOpacitiesPerSpacing(look, context));
  text << 4 * look.colors.size();
  for (const ColorNode& node : look.colors)
  {
    text << ' ' << node.value << ' ' << node.rgb.r << ' ' << node.rgb.g << ' ' << node.rgb.b;
  }
  text << '\n';
  return text.str();
}

}
