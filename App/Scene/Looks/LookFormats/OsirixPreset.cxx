#include "Scene/Looks/LookFormats/LookFormats.h"

#include "Readers/Parsing/Nesting.h"
#include "Scene/Json/JsonCursor.h"

#include <plist/plist.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <memory>
#include <set>

namespace varimarch
{

namespace
{

using PlistOwner = std::unique_ptr<void, decltype(&plist_free)>;

// Looks have three levels.
constexpr int MostLevels = 16;

nlohmann::json JsonOf(plist_t node, int levels);

nlohmann::json JsonOfDictionary(plist_t dictionary, int levels)
{
  nlohmann::json json = nlohmann::json::object();
  plist_dict_iter iterator = nullptr;
  plist_dict_new_iter(dictionary, &iterator);
  for (;;)
  {
    char* key = nullptr;
    plist_t value = nullptr;
    plist_dict_next_item(dictionary, iterator, &key, &value);
    if (!value)
    {
      break;
    }
    json[key] = JsonOf(value, levels);
    std::free(key);
  }
  std::free(iterator);
  return json;
}

// Converts this many levels of a property list to JSON. Deeper ones, dates and binary data, which
// looks do not need, become null.
nlohmann::json JsonOf(plist_t node, int levels)
{
  switch (levels > 0 ? plist_get_node_type(node) : PLIST_NONE)
  {
    case PLIST_DICT:
      return JsonOfDictionary(node, levels - 1);
    case PLIST_ARRAY:
    {
      nlohmann::json json = nlohmann::json::array();
      for (uint32_t i = 0; i < plist_array_get_size(node); ++i)
      {
        json.push_back(JsonOf(plist_array_get_item(node, i), levels - 1));
      }
      return json;
    }
    case PLIST_BOOLEAN:
    {
      uint8_t truth = 0;
      plist_get_bool_val(node, &truth);
      return truth != 0;
    }
    case PLIST_UINT:
    {
      // The library returns negative numbers as their 64-bit two's complement.
      uint64_t number = 0;
      plist_get_uint_val(node, &number);
      return double(int64_t(number));
    }
    case PLIST_REAL:
    {
      double number = 0.0;
      plist_get_real_val(node, &number);
      return number;
    }
    case PLIST_STRING:
      return std::string(plist_get_string_ptr(node, nullptr));
    default:
      return nullptr;
  }
}

nlohmann::json JsonFromPlist(const std::string& bytes, const std::string& file)
{
  if (MayBeNestedTooDeep(bytes))
  {
    FailToReadLook(
      file, "expected at most " + std::to_string(MostNestedElements) + " elements, found more");
  }
  plist_t top = nullptr;
  plist_from_memory(bytes.data(), uint32_t(bytes.size()), &top);
  const PlistOwner owner(top, &plist_free);
  if (!top)
  {
    FailToReadLook(file, "it is not a property list");
  }
  return JsonOf(top, MostLevels);
}

Look CurveOf(const JsonCursor& points, const JsonCursor& colors)
{
  const std::vector<JsonCursor> places = points.Elements(1, MostLookNodes);
  const std::vector<JsonCursor> colorsOfPlaces = colors.Elements(places.size(), places.size());
  Look curve;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const JsonCursor& color = colorsOfPlaces[i];
    const double value = places[i].At("x").Number();
    curve.opacities.push_back({ value, places[i].At("y").Number() });
    curve.colors.push_back({ value,
      { color.At("red").Number(), color.At("green").Number(), color.At("blue").Number() } });
  }
  return curve;
}

bool IsInRangeOf(const Look& curve, double value)
{
  return value >= curve.opacities.front().value && value <= curve.opacities.back().value;
}

// Joins curves that may overlap. At each node, the curve with the largest opacity wins.
Look Joined(const std::vector<Look>& curves)
{
  std::set<double> values;
  std::vector<TransferFunction> functions;
  for (const Look& curve : curves)
  {
    functions.emplace_back(curve.colors, curve.opacities, curve.opacityUnitDistanceMm);
    for (const OpacityNode& node : curve.opacities)
    {
      values.insert(node.value);
    }
  }
  Look joined = curves.front();
  joined.colors.clear();
  joined.opacities.clear();
  for (const double value : values)
  {
    double most = -1.0;
    glm::dvec3 rgb;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      if (IsInRangeOf(curves[i], value) && functions[i].Opacity(value) > most)
      {
        most = functions[i].Opacity(value);
        rgb = functions[i].Color(value);
      }
    }
    joined.opacities.push_back({ value, most });
    joined.colors.push_back({ value, rgb });
  }
  return joined;
}

// Adds transparent ends, over ramps of a thousandth of the curve's width.
Look WithTransparentEnds(Look look)
{
  const double width = look.opacities.back().value - look.opacities.front().value;
  const double way = width > 0.0 ? 0.001 * width : 0.001;
  if (look.opacities.front().opacity > 0.0)
  {
    look.opacities.insert(look.opacities.begin(), { look.opacities.front().value - way, 0.0 });
  }
  if (look.opacities.back().opacity > 0.0)
  {
    look.opacities.push_back({ look.opacities.back().value + way, 0.0 });
  }
  return look;
}

Look LookOfCurves(const JsonCursor& top, const std::string& file, const LookContext& context)
{
  const std::vector<JsonCursor> curves = top.At("16bitClutCurves").Elements(1, MostLookNodes);
  const std::vector<JsonCursor> colors =
    top.At("16bitClutColors").Elements(curves.size(), curves.size());
  std::vector<Look> looks;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    looks.push_back(WithTransparentEnds(CleanLook(CurveOf(curves[i], colors[i]), file, context)));
  }
  return looks.size() > 1 ? Joined(looks) : looks.front();
}

// Every 15th of the 256 colours suffices; linear interpolation fills the gaps.
constexpr std::size_t ColorsApart = 15;

Look LookOfTable(const JsonCursor& top, const LookContext& context)
{
  const auto channel = [&](const char* name) { return top.At(name).Elements(256, 256); };
  const auto red = channel("Red");
  const auto green = channel("Green");
  const auto blue = channel("Blue");
  Look look;
  for (std::size_t i = 0; i < 256; i += ColorsApart)
  {
    look.colors.push_back({ double(i) / 255.0,
      { red[i].Number() / 255.0, green[i].Number() / 255.0, blue[i].Number() / 255.0 } });
  }
  if (!context.opacities.empty())
  {
    Spread(look, context.opacities.front().value, context.opacities.back().value);
  }
  return look;
}

}

Look LookFromPlist(const std::string& bytes, const std::string& file, const LookContext& context)
{
  const nlohmann::json json = JsonFromPlist(bytes, file);
  const JsonCursor top(json, file);
  const bool hasCurves = json.contains("16bitClutCurves");
  if (!hasCurves && !json.contains("Red"))
  {
    const auto table = top.Find("CLUT");
    FailToReadLook(file,
      table ? "its colours are the table \"" + table->Text() + "\", which is not in it"
            : "it holds neither 16bitClutCurves nor a table of colours");
  }
  Look look = hasCurves ? LookOfCurves(top, file, context) : LookOfTable(top, context);
  if (const auto shading = top.Find("useShading"))
  {
    look.shading.enabled = shading->Boolean();
  }
  return CleanLook(look, file, context);
}

}
