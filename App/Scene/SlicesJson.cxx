#include "Scene/SlicesJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

constexpr double MostTurnDegrees = 180.0;

}

SliceSettings SlicesFromJson(const JsonCursor& json)
{
  json.RequireObject({ "crosshair", "turn", "windowLevel", "slab", "slabBlend", "fusion",
    "fusionOpacity", "curveTurn" });
  SliceSettings slices;
  if (const auto crosshair = json.Find("crosshair"))
  {
    slices.crosshairMm = crosshair->Numbers<3>({});
  }
  if (const auto turn = json.Find("turn"))
  {
    slices.turn = turn->Numbers<3>({ -MostTurnDegrees, MostTurnDegrees });
  }
  if (const auto windowLevel = json.Find("windowLevel"))
  {
    slices.windowLevel = windowLevel->Numbers<2>({});
  }
  if (const auto slab = json.Find("slab"))
  {
    slices.slabMm = slab->Number({ 0.0 });
  }
  if (const auto blend = json.Find("slabBlend"))
  {
    slices.slabBlend = blend->Choice(SlabBlendNames());
  }
  if (const auto fusion = json.Find("fusion"))
  {
    slices.fusion = fusion->Choice(SliceFusionNames());
  }
  if (const auto opacity = json.Find("fusionOpacity"))
  {
    slices.fusionOpacity = opacity->Number(UnitInterval);
  }
  if (const auto turn = json.Find("curveTurn"))
  {
    slices.curveTurnDegrees = turn->Number({ -MostTurnDegrees, MostTurnDegrees });
  }
  return slices;
}

nlohmann::ordered_json JsonFromSlices(const SliceSettings& slices)
{
  nlohmann::ordered_json json = { { "slab", slices.slabMm },
    { "slabBlend", NameOf(SlabBlendNames(), slices.slabBlend) },
    { "fusion", NameOf(SliceFusionNames(), slices.fusion) },
    { "fusionOpacity", slices.fusionOpacity } };
  if (slices.crosshairMm)
  {
    json["crosshair"] = *slices.crosshairMm;
  }
  if (slices.turn != SliceTurn())
  {
    json["turn"] = slices.turn;
  }
  if (slices.windowLevel)
  {
    json["windowLevel"] = *slices.windowLevel;
  }
  if (slices.curveTurnDegrees != 0.0)
  {
    json["curveTurn"] = slices.curveTurnDegrees;
  }
  return json;
}

}
