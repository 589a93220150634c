#include "Scene/RegionsJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

std::array<double, 2> SideFromJson(const JsonCursor& json, const NumberRange& range)
{
  const std::array<double, 2> side = json.Numbers<2>(range);
  if (!(side[0] < side[1]))
  {
    json.Fail("expected the smaller end first, found the larger one or two equal ones");
  }
  return side;
}

LookRegion RegionFromJson(const JsonCursor& json)
{
  json.RequireObject({ "shape", "values", "gradients", "rgb", "opacity", "softness" });
  LookRegion region;
  region.shape = json.At("shape").Choice(RegionShapeNames());
  region.values = SideFromJson(json.At("values"), {});
  region.gradients = SideFromJson(json.At("gradients"), { 0.0 });
  const std::array<double, 3> rgb = json.At("rgb").Numbers<3>({ 0.0, 1.0 });
  region.rgb = { rgb[0], rgb[1], rgb[2] };
  region.opacity = json.At("opacity").Number({ 0.0, 1.0 });
  if (const auto softness = json.Find("softness"))
  {
    region.softness = softness->Number({ 0.0, 1.0 });
  }
  return region;
}

}

std::vector<LookRegion> RegionsFromJson(const JsonCursor& json)
{
  std::vector<LookRegion> regions;
  for (const JsonCursor& element : json.Elements(1, MostRegions))
  {
    regions.push_back(RegionFromJson(element));
  }
  return regions;
}

std::vector<LookRegion> ReadRegions(const std::string& path)
{
  const nlohmann::json json = ReadJson(path);
  return RegionsFromJson(JsonCursor(json, path));
}

nlohmann::ordered_json JsonFromRegions(const std::vector<LookRegion>& regions)
{
  nlohmann::ordered_json json;
  for (const LookRegion& region : regions)
  {
    json.push_back(
      { { "shape", NameOf(RegionShapeNames(), region.shape) }, { "values", region.values },
        { "gradients", region.gradients }, { "rgb", { region.rgb.r, region.rgb.g, region.rgb.b } },
        { "opacity", region.opacity }, { "softness", region.softness } });
  }
  return json;
}

}
