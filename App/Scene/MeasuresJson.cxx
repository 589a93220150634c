#include "Scene/MeasuresJson.h"

#include "Scene/MeasureKinds.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

std::string NameFromJson(const JsonCursor& json)
{
  const auto name = json.Find("name");
  return name ? name->Text() : std::string();
}

/// A list of measurements as files had it up to version 0.2.
struct OlderList
{
  const char* key;
  MeasureKind kind;
  std::vector<std::string> points; ///< their keys
};

void ReadOlderList(const JsonCursor& scene, const OlderList& older, std::vector<Measure>& measures)
{
  const auto list = scene.Find(older.key);
  std::vector<std::string> keys = older.points;
  keys.emplace_back("name");
  constexpr std::size_t Most = MostMeasures / 3; // there were three kinds
  for (const JsonCursor& json : list ? list->Elements(0, Most) : std::vector<JsonCursor>())
  {
    json.RequireObject(keys);
    Measure measure = { older.kind, {}, NameFromJson(json) };
    for (const std::string& point : older.points)
    {
      measure.pointsMm.push_back(json.At(point).Numbers<3>());
    }
    measures.push_back(measure);
  }
}

Measure MeasureFromJson(const JsonCursor& json)
{
  json.RequireObject({ "kind", "points", "name", "visible" });
  Measure measure = { json.At("kind").Choice(MeasureKindNames()), {}, NameFromJson(json) };
  const MeasureTraits& traits = TraitsOf(measure.kind);
  for (const JsonCursor& point : json.At("points").Elements(traits.fewestPoints, traits.mostPoints))
  {
    measure.pointsMm.push_back(point.Numbers<3>());
  }
  const auto visible = json.Find("visible");
  measure.visible = !visible || visible->Boolean();
  return measure;
}

}

std::vector<Measure> MeasuresFromJson(const JsonCursor& scene)
{
  std::vector<Measure> measures;
  ReadOlderList(scene, { "distances", MeasureKind::Distance, { "from", "to" } }, measures);
  ReadOlderList(scene, { "angles", MeasureKind::Angle, { "from", "vertex", "to" } }, measures);
  ReadOlderList(scene, { "boxes", MeasureKind::Box, { "from", "to" } }, measures);
  if (const auto list = scene.Find("measures"))
  {
    for (const JsonCursor& json : list->Elements(0, MostMeasures - measures.size()))
    {
      measures.push_back(MeasureFromJson(json));
    }
  }
  return measures;
}

nlohmann::ordered_json JsonFromMeasures(const std::vector<Measure>& measures)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measure& measure : measures)
  {
    nlohmann::ordered_json json = { { "kind", NameOf(MeasureKindNames(), measure.kind) },
      { "points", measure.pointsMm }, { "name", measure.name } };
    if (!measure.visible)
    {
      json["visible"] = false;
    }
    list.push_back(std::move(json));
  }
  return list;
}

}
