#include "Scene/CutsJson.h"

#include "Scene/CameraJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

// Far more than anybody draws by hand.
constexpr std::size_t MostCuts = 1000;
constexpr std::size_t MostOutlinePoints = 100000;

const NameTable<bool>& KeptNames()
{
  static const NameTable<bool> table = { { "outside", false }, { "inside", true } };
  return table;
}

CutPlane CutPlaneFromJson(const JsonCursor& json)
{
  json.RequireObject({ "point", "normal" });
  CutPlane plane = { json.At("point").Numbers<3>({}), json.At("normal").Numbers<3>({}) };
  if (plane.normal == std::array<double, 3>{})
  {
    json.At("normal").Fail("expected a direction, found 0, 0, 0");
  }
  return plane;
}

ScissorsCut ScissorsCutFromJson(const JsonCursor& json)
{
  json.RequireObject({ "camera", "outline", "keep" });
  ScissorsCut cut;
  cut.camera = CameraFromJson(json.At("camera"));
  if (!cut.camera.pose)
  {
    json.At("camera").Fail("expected the key \"pose\", found none");
  }
  for (const JsonCursor& point : json.At("outline").Elements(3, MostOutlinePoints))
  {
    cut.outline.push_back(point.Numbers<2>({}));
  }
  if (const auto keep = json.Find("keep"))
  {
    cut.keepsInside = keep->Choice(KeptNames());
  }
  return cut;
}

}

SceneCuts CutsFromJson(const JsonCursor& json)
{
  json.RequireObject({ "box", "planes", "scissors", "bodyOnly", "faceDepth" });
  SceneCuts cuts;
  if (const auto box = json.Find("box"))
  {
    cuts.box = box->Numbers<6>({ 0.0, 1.0 });
  }
  if (const auto planes = json.Find("planes"))
  {
    for (const JsonCursor& plane : planes->Elements(0, MostCuts))
    {
      cuts.planes.push_back(CutPlaneFromJson(plane));
    }
  }
  if (const auto scissors = json.Find("scissors"))
  {
    for (const JsonCursor& cut : scissors->Elements(0, MostCuts))
    {
      cuts.scissors.push_back(ScissorsCutFromJson(cut));
    }
  }
  if (const auto bodyOnly = json.Find("bodyOnly"))
  {
    cuts.bodyOnly = bodyOnly->Boolean();
  }
  if (const auto depth = json.Find("faceDepth"))
  {
    cuts.faceDepthMm = depth->Number({ 0.0 });
  }
  return cuts;
}

nlohmann::ordered_json JsonFromCuts(const SceneCuts& cuts)
{
  nlohmann::ordered_json json = { { "box", cuts.box },
    { "planes", nlohmann::ordered_json::array() },
    { "scissors", nlohmann::ordered_json::array() } };
  for (const CutPlane& plane : cuts.planes)
  {
    json["planes"].push_back({ { "point", plane.pointMm }, { "normal", plane.normal } });
  }
  for (const ScissorsCut& cut : cuts.scissors)
  {
    json["scissors"].push_back({ { "camera", JsonFromCamera(cut.camera) },
      { "outline", cut.outline }, { "keep", NameOf(KeptNames(), cut.keepsInside) } });
  }
  json["bodyOnly"] = cuts.bodyOnly;
  json["faceDepth"] = cuts.faceDepthMm;
  return json;
}

}
