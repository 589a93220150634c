#include "Scene/Json/SceneFields.h"

#include "Scene/Measures/MeasureKinds.h"

namespace varimarch
{

namespace
{

/// A list of measurements as files had it up to version 0.2. Its measures come first in a scene.
struct OlderList
{
  const char* key;
  MeasureKind kind;
  std::vector<std::string> points; ///< their keys
};

constexpr std::size_t MostOlderMeasures = MostMeasures / 3; // there were three kinds

const std::vector<OlderList>& OlderLists()
{
  static const std::vector<OlderList> lists = { { "distances", MeasureKind::Distance,
                                                  { "from", "to" } },
    { "angles", MeasureKind::Angle, { "from", "vertex", "to" } },
    { "boxes", MeasureKind::Box, { "from", "to" } } };
  return lists;
}

Fields<Measure> OlderFields(const OlderList& older)
{
  Fields<Measure> fields(older.key);
  for (std::size_t i = 0; i < older.points.size(); ++i)
  {
    const JsonForm<std::array<double, 3>> form = NumbersForm<3>();
    fields
      .AddField(
        older.points[i], { "a point", "mm, LPS" }, form.describe,
        [=](const JsonCursor& json, Measure& measure)
        { form.read(json, measure.pointsMm.emplace_back()); },
        [](const Measure&) { return std::nullopt; })
      .Required();
  }
  fields.Add("name", &Measure::name, TextForm(), { "for people" });
  return fields;
}

const Fields<Measure>& MeasureFields()
{
  static const Fields<Measure> fields("measure",
    [](Fields<Measure>& list)
    {
      list.Require("kind", &Measure::kind, ChoiceForm(MeasureKindNames()),
        { "the kind of measurement or annotation, see below" });
      const auto points = [](std::size_t fewest, std::size_t most)
      { return ListForm(NumbersForm<3>(), fewest, most); };
      list
        .AddField(
          "points", { "its points, see below", "mm, LPS" }, points(1, MostMeasurePoints).describe,
          [=](const JsonCursor& json, Measure& measure)
          {
            const MeasureTraits& traits = TraitsOf(measure.kind);
            points(traits.fewestPoints, traits.mostPoints).read(json, measure.pointsMm);
          },
          [](const Measure& measure) { return nlohmann::ordered_json(measure.pointsMm); })
        .Required();
      list.Add(
        "name", &Measure::name, TextForm(), { "for people, or the words of an arrow or a text" });
      list.Add("visible", &Measure::visible, BooleanForm(), { "`false` hides it", "", "`true`" })
        .OmitDefault();
    });
  return fields;
}

void ReadOlder(const OlderList& older, const JsonCursor& json, std::vector<Measure>& measures)
{
  const Fields<Measure> fields = OlderFields(older);
  for (const JsonCursor& one : json.Elements(0, MostOlderMeasures))
  {
    fields.Read(one, measures.emplace_back(Measure{ older.kind, {} }));
  }
}

}

void AddMeasureFields(Fields<Scene>& fields)
{
  for (const OlderList& older : OlderLists())
  {
    fields.AddField(
      older.key, {},
      [=](FormatDescription& format)
      { return SchemaOfArray(OlderFields(older).Describe(format), 0, MostOlderMeasures); },
      [=](const JsonCursor& json, Scene& scene) { ReadOlder(older, json, scene.measures); },
      [](const Scene&) { return std::nullopt; });
  }
  const JsonForm<std::vector<Measure>> form = ListForm(ObjectForm(&MeasureFields), 0, MostMeasures);
  fields.AddField(
    "measures", { "measurements and annotations", "", "none" }, form.describe,
    [](const JsonCursor& json, Scene& scene)
    {
      for (const JsonCursor& one : json.Elements(0, MostMeasures - scene.measures.size()))
      {
        MeasureFields().Read(one, scene.measures.emplace_back());
      }
    },
    [=](const Scene& scene) { return form.write(scene.measures); });
}

}
