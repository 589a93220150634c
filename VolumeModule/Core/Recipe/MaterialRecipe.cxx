#include "Core/Recipe/MaterialRecipe.h"

#include "Core/Recipe/ShaderRecipe.h"

namespace varimarch
{

namespace
{

using Parts = std::vector<std::string>;

std::string ComponentsFile(Components components)
{
  switch (components)
  {
    case Components::LuminanceOpacity:
      return "Components/LuminanceOpacity.glsl";
    case Components::Rgba:
      return "Components/Rgba.glsl";
    default:
      return "Components/Independent.glsl";
  }
}

// True if opacity or light depends on gradients, apart from transfer functions of two values.
bool UsesGradients(const RenderSettings& settings)
{
  return (settings.blend == Blend::Composite || settings.blend == Blend::Slice) &&
    (settings.shading || settings.gradientOpacity || settings.occlusion);
}

Parts LabelParts(const RenderSettings& settings)
{
  const bool hasRegions = settings.functionOf == FunctionOf::ValueAndGradient;
  return { hasRegions || UsesGradients(settings) ? GradientFile(settings) : "Gradient/None.glsl",
    ShadeFile(settings),
    settings.gradientOpacity ? "GradientOpacity/LabelTables.glsl" : "GradientOpacity/None.glsl",
    settings.labelSurfaces ? "LabelLight/Labels.glsl" : "LabelLight/Scalars.glsl",
    "Values/One.glsl", hasRegions ? "Rows/ValueAndGradient.glsl" : "Rows/Tables.glsl",
    "Material/Labelled.glsl" };
}

}

bool MarchesMaterial(const RenderSettings& settings)
{
  const bool isComposite = settings.blend == Blend::Composite;
  return settings.blend == Blend::Slice || settings.overlaps ||
    (isComposite &&
      (settings.shading || settings.gradientOpacity || settings.occlusion ||
        settings.components != Components::One || settings.functionOf != FunctionOf::Value ||
        settings.mask == Mask::Labels));
}

std::string ShadeFile(const RenderSettings& settings)
{
  if (!settings.shading)
  {
    return "Shade/None.glsl";
  }
  return settings.lights ? "Shade/Lights.glsl" : "Shade/HeadLight.glsl";
}

std::vector<std::string> LightParts(const RenderSettings& settings)
{
  Parts parts = { settings.shadows ? "Reach/ShadowRays.glsl" : "Reach/None.glsl" };
  if (settings.shadows)
  {
    parts.push_back(settings.softLights ? "Cone/Disc.glsl" : "Cone/None.glsl");
    parts.push_back(settings.casters ? "Casters/Triangles.glsl" : "Casters/None.glsl");
  }
  parts.push_back(settings.scattering ? "Scatter/HenyeyGreenstein.glsl" : "Scatter/None.glsl");
  return parts;
}

std::vector<std::string> SkyParts(const RenderSettings& settings)
{
  if (!settings.occlusion)
  {
    return { "Sky/None.glsl" };
  }
  if (settings.components != Components::One)
  {
    return { "Outside/Components.glsl", "Sky/OpenSky.glsl" };
  }
  return { "WayOfScalars.glsl",
    settings.labelSurfaces ? "Outside/Labels.glsl" : "Outside/Scalars.glsl", "Sky/OpenSky.glsl" };
}

std::string GradientFile(const RenderSettings& settings)
{
  if (settings.clippedGradients)
  {
    return "Gradient/ClippedDifferences.glsl";
  }
  if (settings.cubic)
  {
    return "Gradient/OfSpline.glsl";
  }
  // On an uneven grid, voxels are not one step of the even grid apart.
  return settings.storedGradients && !settings.uneven ? "Gradient/Stored.glsl"
                                                      : "Gradient/CentralDifferences.glsl";
}

std::vector<std::string> ClassifyParts(const RenderSettings& settings)
{
  const bool hasTwoValues = settings.functionOf != FunctionOf::Value;
  if (settings.mask == Mask::Labels)
  {
    return hasTwoValues ? Parts{ "Classify/LabelTables.glsl", "ClassifyTwo/Table.glsl" }
                        : Parts{ "Classify/LabelTables.glsl" };
  }
  if (hasTwoValues)
  {
    return { "ClassifyTwo/Table.glsl" };
  }
  if (settings.components == Components::One)
  {
    return { UsesPreIntegration(settings) ? "Classify/PreIntegrated.glsl"
                                          : "Classify/OpticalTable.glsl" };
  }
  return { "Classify/ComponentTables.glsl", ComponentsFile(settings.components) };
}

std::vector<std::string> MaterialParts(const RenderSettings& settings)
{
  if (settings.functionOf == FunctionOf::TwoValues)
  {
    const bool hasSurfaces = settings.shading || settings.occlusion;
    return { hasSurfaces ? GradientFile(settings) : "Gradient/None.glsl", ShadeFile(settings),
      "Values/Two.glsl", "Material/TwoValues.glsl" };
  }
  if (settings.mask == Mask::Labels)
  {
    return LabelParts(settings);
  }
  if (settings.functionOf == FunctionOf::ValueAndGradient)
  {
    return { GradientFile(settings), ShadeFile(settings), "Values/One.glsl",
      "Material/ValueAndGradient.glsl" };
  }
  const std::string opacity =
    settings.gradientOpacity ? "GradientOpacity/Table.glsl" : "GradientOpacity/None.glsl";
  if (settings.components == Components::One)
  {
    return { UsesGradients(settings) ? GradientFile(settings) : "Gradient/None.glsl",
      ShadeFile(settings), opacity, "Values/One.glsl", "Material/OneComponent.glsl" };
  }
  const std::string gradients =
    settings.cubic ? "Gradient/OfSplines.glsl" : "Gradient/CentralDifferencesOfAll.glsl";
  return { UsesGradients(settings) ? gradients : "Gradient/NoneOfAll.glsl", ShadeFile(settings),
    opacity, "Values/All.glsl", "Material/Components.glsl" };
}

}
