#include "Scene/SlicerProperty.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace varimarch
{

namespace
{

// As many nodes as our own files may have, of colour, which have most numbers.
constexpr std::size_t MostNumbers = 40000;

/// The numbers of a line, which must be all that it holds.
std::vector<double> NumbersOfLine(std::istream& lines, const std::string& file, const char* what)
{
  std::string line;
  std::getline(lines, line);
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0.0;
  while (numbers.size() <= MostNumbers && stream >> number)
  {
    numbers.push_back(number);
  }
  if (numbers.empty() || !stream.eof())
  {
    throw std::runtime_error("Cannot read " + file + ": expected numbers for the " + what +
      ", found \"" + line.substr(0, 40) + "\".");
  }
  return numbers;
}

/// The numbers of a curve, after the one that counts them.
std::vector<double> NumbersOfCurve(
  std::istream& lines, const std::string& file, const char* what, std::size_t perNode)
{
  std::vector<double> numbers = NumbersOfLine(lines, file, what);
  const double promised = numbers.front();
  numbers.erase(numbers.begin());
  if (promised != double(numbers.size()) || numbers.empty() || numbers.size() % perNode != 0)
  {
    throw std::runtime_error("Cannot read " + file + ": the " + what + " promises " +
      std::to_string(std::lround(std::clamp(promised, -1e9, 1e9))) + " numbers, " +
      std::to_string(perNode) + " for each node, the line holds " + std::to_string(numbers.size()) +
      ".");
  }
  return numbers;
}

template <class Node>
void SortByValue(std::vector<Node>& nodes)
{
  // Stable: two nodes at a value are a step, whose sides must not change places.
  std::stable_sort(
    nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.value < b.value; });
}

double ToUnit(double number)
{
  return std::clamp(number, 0.0, 1.0);
}

}

Look LookFromSlicerText(const std::string& text, const std::string& file)
{
  std::istringstream lines(text);
  const auto number = [&](const char* what) { return NumbersOfLine(lines, file, what).front(); };
  Look look;
  look.name = std::filesystem::path(file).stem().string();
  number("interpolation");
  look.shading.enabled = number("shading") != 0.0;
  look.shading.diffuse = ToUnit(number("diffuse coefficient"));
  look.shading.ambient = ToUnit(number("ambient coefficient"));
  look.shading.specular = ToUnit(number("specular coefficient"));
  look.shading.specularPower = std::clamp(number("specular power"), 1.0, 1000.0);
  const auto opacities = NumbersOfCurve(lines, file, "scalar opacity", 2);
  for (std::size_t i = 0; i < opacities.size(); i += 2)
  {
    look.opacities.push_back({ opacities[i], ToUnit(opacities[i + 1]) });
  }
  NumbersOfCurve(lines, file, "gradient opacity", 2);
  const auto colors = NumbersOfCurve(lines, file, "colours", 4);
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    look.colors.push_back(
      { colors[i], { ToUnit(colors[i + 1]), ToUnit(colors[i + 2]), ToUnit(colors[i + 3]) } });
  }
  SortByValue(look.opacities);
  SortByValue(look.colors);
  return look;
}

std::string SlicerText(const Look& look)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "1\n"
       << int(look.shading.enabled) << '\n'
       << look.shading.diffuse << '\n'
       << look.shading.ambient << '\n'
       << look.shading.specular << '\n'
       << look.shading.specularPower << '\n'
       << 2 * look.opacities.size();
  for (const OpacityNode& node : look.opacities)
  {
    text << ' ' << node.value << ' ' << node.opacity;
  }
  // No gradient opacity: 1 everywhere.
  text << "\n4 0 1 255 1\n" << 4 * look.colors.size();
  for (const ColorNode& node : look.colors)
  {
    text << ' ' << node.value << ' ' << node.rgb.r << ' ' << node.rgb.g << ' ' << node.rgb.b;
  }
  text << '\n';
  return text.str();
}

}
