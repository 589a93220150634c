#include "Scene/CameraJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

std::array<double, 2> ClippingRangeFromJson(const JsonCursor& json)
{
  const std::array<double, 2> range = json.Numbers<2>(Positive);
  if (!(range[0] < range[1]))
  {
    json.Fail("expected the nearer distance first, found the farther one or two equal ones");
  }
  return range;
}

CameraPose PoseFromJson(const JsonCursor& json)
{
  json.RequireObject({ "position", "focalPoint", "viewUp", "parallelScale" });
  return { json.At("position").Numbers<3>({}), json.At("focalPoint").Numbers<3>({}),
    json.At("viewUp").Numbers<3>({}), json.At("parallelScale").Number(Positive) };
}

}

Camera CameraFromJson(const JsonCursor& json)
{
  json.RequireObject(
    { "view", "azimuth", "elevation", "zoom", "projection", "viewAngle", "pose", "clippingRange" });
  Camera camera;
  if (const auto view = json.Find("view"))
  {
    camera.view = view->Choice(ViewNames());
  }
  if (const auto azimuth = json.Find("azimuth"))
  {
    camera.azimuthDegrees = azimuth->Number();
  }
  if (const auto elevation = json.Find("elevation"))
  {
    camera.elevationDegrees = elevation->Number({ -90.0, 90.0, true, true });
  }
  if (const auto zoom = json.Find("zoom"))
  {
    camera.zoom = zoom->Number(Positive);
  }
  if (const auto projection = json.Find("projection"))
  {
    camera.parallel = projection->Choice(ProjectionNames());
  }
  if (const auto angle = json.Find("viewAngle"))
  {
    camera.viewAngleDegrees = angle->Number({ 0.0, 180.0, true, true });
  }
  if (const auto pose = json.Find("pose"))
  {
    camera.pose = PoseFromJson(*pose);
  }
  if (const auto range = json.Find("clippingRange"))
  {
    camera.clippingRangeMm = ClippingRangeFromJson(*range);
  }
  return camera;
}

nlohmann::ordered_json JsonFromCamera(const Camera& camera)
{
  nlohmann::ordered_json json = { { "view", NameOf(ViewNames(), camera.view) },
    { "azimuth", camera.azimuthDegrees }, { "elevation", camera.elevationDegrees },
    { "zoom", camera.zoom }, { "projection", NameOf(ProjectionNames(), camera.parallel) },
    { "viewAngle", camera.viewAngleDegrees } };
  if (camera.pose)
  {
    json["pose"] = { { "position", camera.pose->positionMm },
      { "focalPoint", camera.pose->focalPointMm }, { "viewUp", camera.pose->viewUp },
      { "parallelScale", camera.pose->parallelScaleMm } };
  }
  if (camera.clippingRangeMm)
  {
    json["clippingRange"] = *camera.clippingRangeMm;
  }
  return json;
}

}
