#include "Scene/MeasuresJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

// Far more than anybody measures by hand.
constexpr std::size_t MostMeasures = 1000;

std::string NameFromJson(const JsonCursor& json)
{
  const auto name = json.Find("name");
  return name ? name->Text() : std::string();
}

// Measurements that are given by two points.
template <class Measure>
std::vector<Measure> PairsFromJson(const JsonCursor& scene, const char* key)
{
  std::vector<Measure> measures;
  if (const auto list = scene.Find(key))
  {
    for (const JsonCursor& json : list->Elements(0, MostMeasures))
    {
      json.RequireObject({ "from", "to", "name" });
      measures.push_back(
        { json.At("from").Numbers<3>({}), json.At("to").Numbers<3>({}), NameFromJson(json) });
    }
  }
  return measures;
}

template <class Measure>
nlohmann::ordered_json JsonFromPairs(const std::vector<Measure>& measures)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Measure& measure : measures)
  {
    json.push_back(
      { { "from", measure.fromMm }, { "to", measure.toMm }, { "name", measure.name } });
  }
  return json;
}

}

std::vector<Distance> DistancesFromJson(const JsonCursor& scene)
{
  return PairsFromJson<Distance>(scene, "distances");
}

std::vector<MeasuredBox> BoxesFromJson(const JsonCursor& scene)
{
  return PairsFromJson<MeasuredBox>(scene, "boxes");
}

std::vector<Angle> AnglesFromJson(const JsonCursor& scene)
{
  std::vector<Angle> angles;
  if (const auto list = scene.Find("angles"))
  {
    for (const JsonCursor& json : list->Elements(0, MostMeasures))
    {
      json.RequireObject({ "from", "vertex", "to", "name" });
      angles.push_back({ json.At("from").Numbers<3>({}), json.At("vertex").Numbers<3>({}),
        json.At("to").Numbers<3>({}), NameFromJson(json) });
    }
  }
  return angles;
}

nlohmann::ordered_json JsonFromDistances(const std::vector<Distance>& distances)
{
  return JsonFromPairs(distances);
}

nlohmann::ordered_json JsonFromBoxes(const std::vector<MeasuredBox>& boxes)
{
  return JsonFromPairs(boxes);
}

nlohmann::ordered_json JsonFromAngles(const std::vector<Angle>& angles)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Angle& angle : angles)
  {
    json.push_back({ { "from", angle.fromMm }, { "vertex", angle.vertexMm }, { "to", angle.toMm },
      { "name", angle.name } });
  }
  return json;
}

}
