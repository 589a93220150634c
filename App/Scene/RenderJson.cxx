#include "Scene/RenderJson.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace varimarch
{

namespace
{

// A number, or the word "auto" to let the mapper choose.
std::optional<double> NumberOrAuto(const JsonCursor& json, const NumberRange& range)
{
  if (!json.IsText())
  {
    return json.Number(range);
  }
  if (json.Text() != "auto")
  {
    json.FailExpecting(range.Description() + " or \"auto\"");
  }
  return std::nullopt;
}

template <class Value>
std::optional<Value> ChoiceOrAuto(const JsonCursor& json, const NameTable<Value>& names)
{
  return json.IsText() && json.Text() == "auto" ? std::nullopt : std::optional(json.Choice(names));
}

nlohmann::ordered_json JsonFromOptional(const std::optional<double>& number)
{
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json("auto");
}

void ReadSpan(const JsonCursor& json, RenderOptions& render)
{
  if (const auto voxels = json.Find("sampleDistanceVoxels"))
  {
    render.sampleDistanceVoxels = NumberOrAuto(*voxels, Positive);
  }
  if (const auto steps = json.Find("steps"))
  {
    render.mostSteps = steps->Integer(0, std::numeric_limits<int>::max());
  }
  if (const auto distance = json.Find("firstDistance"))
  {
    render.firstDistanceMm = distance->Number({ 0.0 });
  }
}

}

void ReadRender(const JsonCursor& json, RenderOptions& render)
{
  json.RequireObject({ "sampleDistance", "errorTolerance", "acceleration", "integration",
    "variationTolerance", "earlyTermination", "interpolation", "detail", "jitter",
    "sampleDistanceVoxels", "steps", "firstDistance" });
  if (const auto distance = json.Find("sampleDistance"))
  {
    render.sampleDistanceMm = NumberOrAuto(*distance, Positive);
  }
  if (const auto tolerance = json.Find("errorTolerance"))
  {
    render.errorTolerance = tolerance->Number({ 0.0, 1.0 });
  }
  if (const auto acceleration = json.Find("acceleration"))
  {
    render.acceleration = acceleration->Choice(AccelerationNames());
  }
  if (const auto integration = json.Find("integration"))
  {
    render.integration = ChoiceOrAuto(*integration, IntegrationNames());
  }
  if (const auto tolerance = json.Find("variationTolerance"))
  {
    render.variationTolerance = NumberOrAuto(*tolerance, { 0.0 });
  }
  if (const auto transmittance = json.Find("earlyTermination"))
  {
    render.earlyTerminationTransmittance = transmittance->Number({ 0.0, 1.0, false, true });
  }
  if (const auto interpolation = json.Find("interpolation"))
  {
    render.interpolation = interpolation->Choice(InterpolationNames());
  }
  if (const auto detail = json.Find("detail"))
  {
    render.level = detail->Choice(LevelNames());
  }
  if (const auto jitter = json.Find("jitter"))
  {
    render.jitter = jitter->Boolean();
  }
  ReadSpan(json, render);
}

nlohmann::ordered_json JsonFromRender(const RenderOptions& render)
{
  return { { "sampleDistance", JsonFromOptional(render.sampleDistanceMm) },
    { "acceleration", NameOf(AccelerationNames(), render.acceleration) },
    { "errorTolerance", render.errorTolerance },
    { "integration",
      render.integration ? NameOf(IntegrationNames(), *render.integration) : "auto" },
    { "variationTolerance", JsonFromOptional(render.variationTolerance) },
    { "earlyTermination", render.earlyTerminationTransmittance },
    { "interpolation", NameOf(InterpolationNames(), render.interpolation) },
    { "detail", NameOf(LevelNames(), render.level) }, { "jitter", render.jitter },
    { "sampleDistanceVoxels", JsonFromOptional(render.sampleDistanceVoxels) },
    { "steps", render.mostSteps }, { "firstDistance", render.firstDistanceMm } };
}

}
