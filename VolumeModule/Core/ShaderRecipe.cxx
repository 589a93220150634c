#include "Core/ShaderRecipe.h"

#include <stdexcept>

namespace varimarch
{

namespace
{

std::string StepFile(Acceleration acceleration)
{
  switch (acceleration)
  {
    case Acceleration::ScalarField:
      return "Step/VariationField.glsl";
    case Acceleration::OpticalField:
      return "Step/OpticalField.glsl";
    case Acceleration::Off:
      break;
  }
  return "Step/Fixed.glsl";
}

std::string BlendFile(Blend blend)
{
  switch (blend)
  {
    case Blend::MaximumIntensity:
      return "Blend/MaximumIntensity.glsl";
    case Blend::Composite:
      return "Blend/Composite.glsl";
    default:
      throw std::invalid_argument("Shader: there is none yet for this blend mode");
  }
}

bool UsesShading(const RenderSettings& settings)
{
  return settings.shading && settings.blend == Blend::Composite;
}

}

std::vector<std::string> FragmentShaderParts(const RenderSettings& settings)
{
  std::vector<std::string> parts = {
    "Slots.glsl",
    "Math/IntersectBox.glsl",
    "Math/Absorption.glsl",
    settings.sceneGeometry ? "Depth/SceneGeometry.glsl" : "Depth/None.glsl",
    StepFile(settings.acceleration),
    "Classify/OpticalTable.glsl",
  };
  // A projection shows values, not surfaces: it has nothing to shade.
  if (settings.blend == Blend::Composite)
  {
    parts.push_back(UsesShading(settings) ? "Shade/BlinnPhong.glsl" : "Shade/None.glsl");
  }
  parts.push_back(BlendFile(settings.blend));
  parts.push_back(UsesShading(settings) ? "March/VisibleSegments.glsl" : "March/EverySample.glsl");
  parts.push_back("RayMarch.frag.glsl");
  return parts;
}

std::string VertexShaderPart()
{
  return "RayMarch.vert.glsl";
}

std::vector<RenderSettings> EveryRecipe()
{
  std::vector<RenderSettings> recipes;
  for (Acceleration acceleration :
    { Acceleration::Off, Acceleration::ScalarField, Acceleration::OpticalField })
  {
    for (bool sceneGeometry : { false, true })
    {
      for (bool shading : { false, true })
      {
        recipes.push_back({ Blend::Composite, acceleration, shading, sceneGeometry });
      }
      // What is invisible to a composite may be the maximum: that field serves composites only.
      if (acceleration != Acceleration::OpticalField)
      {
        recipes.push_back({ Blend::MaximumIntensity, acceleration, false, sceneGeometry });
      }
    }
  }
  return recipes;
}

}
