#include "Scene/Looks/LookFormats/LookFormats.h"

#include <array>
#include <locale>
#include <map>
#include <sstream>

namespace varimarch
{

namespace
{

// All keys and values. Sections are ignored, since no key occurs in two of them.
class Settings
{
public:
  Settings(const std::string& text, const std::string& file)
    : file(file)
  {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
      const std::size_t equals = line.find('=');
      if (equals != std::string::npos)
      {
        this->values[line.substr(0, equals)] = line.substr(equals + 1);
      }
    }
  }

  bool Has(const std::string& key) const { return this->values.count(key) > 0; }

  /// The numbers of a key, separated by "|".
  template <std::size_t count>
  std::array<double, count> Numbers(const std::string& key) const
  {
    const auto found = this->values.find(key);
    std::istringstream stream(found == this->values.end() ? "" : found->second);
    stream.imbue(std::locale::classic());
    std::array<double, count> numbers;
    for (std::size_t i = 0; i < count; ++i)
    {
      char bar = '|';
      if ((i > 0 && !(stream >> bar)) || bar != '|' || !(stream >> numbers[i]))
      {
        FailToReadLook(this->file,
          "expected " + std::to_string(count) + (count == 1 ? " number" : " numbers") + " for " +
            key + ", found \"" + stream.str().substr(0, 40) + "\"");
      }
    }
    return numbers;
  }

private:
  std::string file;
  std::map<std::string, std::string> values;
};

}

Look LookFromClut(const std::string& text, const std::string& file, const LookContext& context)
{
  const Settings settings(text, file);
  const double count = settings.Numbers<1>("numnodes")[0];
  if (!(count >= 1.0 && count <= double(MostLookNodes)))
  {
    FailToReadLook(file,
      "expected 1 to " + std::to_string(MostLookNodes) +
        " nodes, found numnodes=" + std::to_string(count));
  }
  Look look;
  for (int i = 0; i < int(count); ++i)
  {
    const std::string number = std::to_string(i);
    const double place = settings.Numbers<1>("nodeintensity" + number)[0] / 255.0;
    const std::array<double, 4> rgba = settings.Numbers<4>("nodergba" + number);
    look.colors.push_back({ place, { rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0 } });
    look.opacities.push_back({ place, rgba[3] / 255.0 });
  }
  const bool hasValues = settings.Has("min") && settings.Has("max");
  const double smallest = hasValues ? settings.Numbers<1>("min")[0] : 0.0;
  const double largest = hasValues ? settings.Numbers<1>("max")[0] : 0.0;
  const bool named = largest > smallest;
  Spread(look, named ? smallest : context.smallest, named ? largest : context.largest);
  return CleanLook(look, file, context);
}

}
