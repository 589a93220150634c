#include "Core/PassRecipe.h"

#include <stdexcept>

namespace varimarch
{

namespace
{

std::string ComponentBlendFile(Blend blend)
{
  switch (blend)
  {
    case Blend::MaximumIntensity:
    case Blend::MinimumIntensity:
      return "Blend/ComponentExtreme.glsl";
    case Blend::AverageIntensity:
      return "Blend/ComponentAverage.glsl";
    default:
      return "Blend/ComponentAdditive.glsl";
  }
}

}

std::string BlendFile(const RenderSettings& settings)
{
  const Blend blend = settings.blend;
  if (settings.components != Components::One && IsProjection(blend))
  {
    return ComponentBlendFile(blend);
  }
  switch (blend)
  {
    case Blend::Composite:
      return "Blend/Composite.glsl";
    case Blend::MaximumIntensity:
      return "Blend/MaximumIntensity.glsl";
    case Blend::MinimumIntensity:
      return "Blend/MinimumIntensity.glsl";
    case Blend::AverageIntensity:
      return "Blend/AverageIntensity.glsl";
    case Blend::Additive:
      return "Blend/Additive.glsl";
    case Blend::Isosurface:
    case Blend::Slice:
      return "Blend/Composite.glsl"; // of surfaces, each of an optical depth
  }
  throw std::invalid_argument("Shader: unknown blend mode");
}

std::string ResumeFile(RayPass pass)
{
  switch (pass)
  {
    case RayPass::Block:
      return "Resume/Block.glsl";
    case RayPass::Picture:
      return "Resume/Picture.glsl";
    case RayPass::Upscaled:
      return "Resume/Upscaled.glsl";
    case RayPass::Averaged:
      return "Resume/Averaged.glsl";
    case RayPass::PeelOutside:
      return "Resume/PeelOutside.glsl";
    case RayPass::PeelBetween:
      return "Resume/PeelBetween.glsl";
    case RayPass::PeelLast:
      return "Resume/PeelLast.glsl";
    case RayPass::PickProp:
      return "Resume/PickProp.glsl";
    case RayPass::PickVoxel:
      return "Resume/PickVoxel.glsl";
    case RayPass::PictureAndDepth:
      return "Resume/PictureAndDepth.glsl";
    case RayPass::Accumulated: // have shaders of their own
    case RayPass::Marched:
    case RayPass::Whole:
      break;
  }
  return "Resume/Whole.glsl";
}

std::string WindowFile(const RenderSettings& settings)
{
  return settings.windowLevel ? "Window/WindowLevel.glsl" : "Window/None.glsl";
}

std::vector<std::string> PassParts(const RenderSettings& settings)
{
  std::vector<std::string> parts;
  if (settings.pass == RayPass::Whole || settings.pass == RayPass::PictureAndDepth ||
    Peels(settings.pass))
  {
    parts.push_back(WindowFile(settings));
  }
  if (Peels(settings.pass))
  {
    parts.push_back("Peel/Segment.glsl");
  }
  if (Locates(settings.pass))
  {
    parts.push_back("Locate/Opacity.glsl");
  }
  parts.push_back(ResumeFile(settings.pass));
  return parts;
}

}
