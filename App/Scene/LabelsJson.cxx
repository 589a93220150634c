#include "Scene/LabelsJson.h"

#include "Scene/LabelMap.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

Segment SegmentFromJson(const JsonCursor& json)
{
  json.RequireObject({ "value", "name", "color", "visible", "opacity" });
  const std::array<double, 3> rgb = json.At("color").Numbers<3>(UnitInterval);
  const JsonCursor value = json.At("value");
  Segment segment = { value.Integer(SmallestLabel, LargestLabel), {}, { rgb[0], rgb[1], rgb[2] } };
  if (segment.value == 0)
  {
    value.Fail("expected the value of a segment, found 0, which means no segment");
  }
  if (const auto name = json.Find("name"))
  {
    segment.name = name->Text();
  }
  if (const auto visible = json.Find("visible"))
  {
    segment.visible = visible->Boolean();
  }
  if (const auto opacity = json.Find("opacity"))
  {
    segment.opacity = opacity->Number(UnitInterval);
  }
  return segment;
}

}

std::vector<Segment> SegmentsFromJson(const JsonCursor& json)
{
  std::vector<Segment> segments;
  for (const JsonCursor& element : json.Elements(0, MostSegments))
  {
    const Segment segment = SegmentFromJson(element);
    const bool isKnown = std::any_of(segments.begin(), segments.end(),
      [&](const Segment& other) { return other.value == segment.value; });
    if (isKnown)
    {
      element.At("value").Fail("expected another value for each segment, found " +
        std::to_string(segment.value) + " twice");
    }
    segments.push_back(segment);
  }
  return segments;
}

SceneLabels LabelsFromJson(const JsonCursor& json)
{
  json.RequireObject({ "file", "series", "segments" });
  SceneLabels labels = { json.At("file").Text() };
  if (const auto series = json.Find("series"))
  {
    labels.series = series->Text();
  }
  if (const auto segments = json.Find("segments"))
  {
    labels.segments = SegmentsFromJson(*segments);
  }
  return labels;
}

nlohmann::ordered_json JsonFromLabels(const SceneLabels& labels)
{
  nlohmann::ordered_json json = { { "file", labels.path } };
  if (!labels.series.empty())
  {
    json["series"] = labels.series;
  }
  json["segments"] = nlohmann::ordered_json::array();
  for (const Segment& segment : labels.segments)
  {
    json["segments"].push_back({ { "value", segment.value }, { "name", segment.name },
      { "color", { segment.rgb.r, segment.rgb.g, segment.rgb.b } }, { "visible", segment.visible },
      { "opacity", segment.opacity } });
  }
  return json;
}

}
