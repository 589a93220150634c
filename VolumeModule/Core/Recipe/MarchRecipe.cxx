#include "Core/Recipe/MarchRecipe.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Core/Recipe/PassRecipe.h"

namespace varimarch
{

namespace
{

std::string FileFromBehind(const RenderSettings& settings)
{
  return MarchesMaterial(settings) ? "March/MaterialFromBehind.glsl"
                                   : "March/MidpointFromBehind.glsl";
}

// The rule of composites of one scalar.
std::string RuleFile(Integration integration)
{
  switch (integration)
  {
    case Integration::PreIntegrated:
      return "March/PreIntegrated.glsl";
    case Integration::Simpson:
      return "March/Simpson.glsl";
    case Integration::PublishedSum:
      return "March/PublishedSum.glsl";
    case Integration::FirstHit:
      return "March/FirstHit.glsl";
    case Integration::Midpoint:
      break;
  }
  return "March/Midpoint.glsl";
}

std::string MarchFile(const RenderSettings& settings)
{
  if (settings.blend == Blend::Isosurface)
  {
    return settings.nearest ? "March/VoxelSurfaces.glsl" : "March/Isosurfaces.glsl";
  }
  if (settings.blend == Blend::Slice)
  {
    return "March/Slice.glsl";
  }
  if (IsProjection(settings.blend) && settings.components != Components::One)
  {
    return "March/Projection.glsl";
  }
  if (IsOfBoxes(settings))
  {
    return MarchesMaterial(settings)       ? "March/MaterialVoxels.glsl"
      : settings.blend == Blend::Composite ? "March/Voxels.glsl"
                                           : "March/ProjectedVoxels.glsl";
  }
  if (settings.limitsMean)
  {
    return "March/RangeMean.glsl";
  }
  if (settings.blend != Blend::Composite)
  {
    return IsSampled(settings) ? "March/Projection.glsl" : "March/Extreme.glsl";
  }
  if (settings.fromBehind)
  {
    return FileFromBehind(settings);
  }
  if (MarchesMaterial(settings))
  {
    return settings.integration == Integration::Midpoint ? "March/MaterialMidpoint.glsl"
                                                         : "March/MaterialSegments.glsl";
  }
  return RuleFile(settings.integration);
}

// The loop along a ray that calls a rule; empty if the rule has a loop of its own.
std::vector<std::string> LoopParts(const std::string& march)
{
  for (const char* const rule : { "Midpoint", "PreIntegrated", "Simpson", "Projection" })
  {
    if (march == std::string("March/") + rule + ".glsl")
    {
      return { "Loop/Segments.glsl" };
    }
  }
  for (const char* const rule : { "Voxels", "ProjectedVoxels", "MaterialVoxels", "VoxelSurfaces",
         "Isosurfaces", "Extreme", "RangeMean" })
  {
    if (march == std::string("March/") + rule + ".glsl")
    {
      return { "Loop/Cells.glsl" };
    }
  }
  return {};
}

}

bool IsOfBoxes(const RenderSettings& settings)
{
  return settings.nearest && !settings.uneven;
}

std::string StepFile(const RenderSettings& settings)
{
  switch (settings.acceleration)
  {
    case Acceleration::CellField:
      return "Step/CellField.glsl";
    case Acceleration::VariationField:
      return "Step/VariationField.glsl";
    case Acceleration::OpticalField:
      if (IsExtreme(settings.blend))
      {
        return "Step/BrickExtremes.glsl";
      }
      return settings.skipsBricks ? "Step/OpticalField.glsl" : "Step/Growing.glsl";
    case Acceleration::Off:
      break;
  }
  return "Step/Fixed.glsl";
}

std::vector<std::string> MarchParts(const RenderSettings& settings)
{
  const std::string march = MarchFile(settings);
  std::vector<std::string> parts = LoopParts(march);
  if (settings.blend == Blend::Isosurface)
  {
    parts.push_back("SurfaceTable.glsl");
  }
  if (march == "March/Projection.glsl")
  {
    parts.push_back(
      settings.components == Components::One ? "Sample/Scalar.glsl" : "Sample/Texel.glsl");
  }
  if (march == "March/Midpoint.glsl" || march == "March/PreIntegrated.glsl" ||
    march == "March/MidpointFromBehind.glsl")
  {
    parts.push_back("FourScalars.glsl");
  }
  if (march.rfind("March/Material", 0) == 0)
  {
    const std::vector<std::string> sky = SkyParts(settings);
    parts.insert(parts.end(), sky.begin(), sky.end());
  }
  if (march == FileFromBehind(settings))
  {
    parts.push_back("FromBehind.glsl");
  }
  parts.push_back(march);
  return parts;
}

}
