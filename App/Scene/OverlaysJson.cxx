#include "Scene/OverlaysJson.h"

#include "Scene/LabelsJson.h"
#include "Scene/LookJson.h"
#include "Scene/VolumeJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

Placement PlacementFromJson(const JsonCursor& json)
{
  json.RequireObject({ "turn", "move" });
  Placement placement;
  if (const auto turn = json.Find("turn"))
  {
    placement.turnDegrees = turn->Numbers<3>({});
  }
  if (const auto move = json.Find("move"))
  {
    placement.moveMm = move->Numbers<3>({});
  }
  return placement;
}

void ReadAppearance(const JsonCursor& json, OverlaidVolume& overlay)
{
  if (const auto visible = json.Find("visible"))
  {
    overlay.visible = visible->Boolean();
  }
  if (const auto opacity = json.Find("opacity"))
  {
    overlay.opacity = opacity->Number(UnitInterval);
  }
  if (const auto colors = json.Find("sliceColors"))
  {
    overlay.sliceColors = colors->Choice(SliceColorsNames());
  }
  if (const auto windowLevel = json.Find("windowLevel"))
  {
    overlay.windowLevel = windowLevel->Numbers<2>({});
  }
}

OverlaidVolume OverlayFromJson(const JsonCursor& json)
{
  json.RequireObject({ "volume", "look", "name", "placement", "visible", "opacity", "sliceColors",
    "windowLevel", "labels" });
  OverlaidVolume overlay = { VolumeFromJson(json.At("volume")),
    PresetFromJson(json.At("look")).look };
  if (const auto name = json.Find("name"))
  {
    overlay.name = name->Text();
  }
  if (const auto placement = json.Find("placement"))
  {
    overlay.placement = PlacementFromJson(*placement);
  }
  ReadAppearance(json, overlay);
  if (const auto labels = json.Find("labels"))
  {
    overlay.labels = LabelsFromJson(*labels);
  }
  return overlay;
}

}

std::vector<OverlaidVolume> OverlaysFromJson(const JsonCursor& json)
{
  std::vector<OverlaidVolume> overlays;
  for (const JsonCursor& element : json.Elements(0, MostVolumes - 1))
  {
    overlays.push_back(OverlayFromJson(element));
  }
  return overlays;
}

nlohmann::ordered_json JsonFromOverlays(const std::vector<OverlaidVolume>& overlays)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OverlaidVolume& overlay : overlays)
  {
    nlohmann::ordered_json json = { { "volume", JsonFromVolume(overlay.source) },
      { "look", JsonFromLook(overlay.look) }, { "name", overlay.name },
      { "placement",
        { { "turn", overlay.placement.turnDegrees }, { "move", overlay.placement.moveMm } } },
      { "visible", overlay.visible }, { "opacity", overlay.opacity },
      { "sliceColors", NameOf(SliceColorsNames(), overlay.sliceColors) } };
    if (overlay.windowLevel)
    {
      json["windowLevel"] = *overlay.windowLevel;
    }
    if (overlay.labels)
    {
      json["labels"] = JsonFromLabels(*overlay.labels);
    }
    list.push_back(json);
  }
  return list;
}

}
