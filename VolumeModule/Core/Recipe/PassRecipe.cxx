#include "Core/Recipe/PassRecipe.h"

#include "Core/Recipe/ShaderRecipe.h"

#include <algorithm>
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
      return "Blend/Composite.glsl"; // surfaces are composited, each with an optical depth
  }
  throw std::invalid_argument("Shader: unknown blend mode");
}

std::vector<std::string> VertexShaderParts()
{
  return { "RayParameters.glsl", "VolumeParameters.glsl", "PassParameters.glsl",
    "RayMarch.vert.glsl" };
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
    case RayPass::PeelBetween:
    case RayPass::PeelLast:
      return "Resume/Peel.glsl";
    case RayPass::PickProp:
      return "Resume/PickProp.glsl";
    case RayPass::PickVoxel:
      return "Resume/PickVoxel.glsl";
    case RayPass::PictureAndDepth:
      return "Resume/PictureAndDepth.glsl";
    case RayPass::Accumulated: // uses Mean.frag.glsl instead
    case RayPass::Whole:
      break;
  }
  return "Resume/Whole.glsl";
}

std::string MarchedFile(RayPass pass)
{
  switch (pass)
  {
    case RayPass::PickProp:
      return "Marched/PickProp.frag.glsl";
    case RayPass::PickVoxel:
      return "Marched/PickVoxel.frag.glsl";
    case RayPass::PictureAndDepth:
      return "Marched/PictureAndDepth.frag.glsl";
    default:
      return Peels(pass) ? "Marched/Layers.frag.glsl" : "Marched/Whole.frag.glsl";
  }
}

std::string LocateFile(RayPass pass)
{
  return pass == RayPass::PickVoxel ? "Locate/VoxelNumber.glsl" : "Locate/Depth.glsl";
}

std::string PeelFile(RayPass pass)
{
  switch (pass)
  {
    case RayPass::PeelOutside:
      return "Peel/Outside.glsl";
    case RayPass::PeelBetween:
      return "Peel/Between.glsl";
    default:
      return "Peel/Last.glsl";
  }
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
    parts.push_back(PeelFile(settings.pass));
  }
  if (Locates(settings.pass))
  {
    parts.insert(parts.end(), { LocateFile(settings.pass), "FirstOpacity.glsl" });
  }
  parts.push_back(ResumeFile(settings.pass));
  return parts;
}

// A shader without a march: it writes the layer depths that the CPU's march needs, shows its image,
// or dims the geometry that the volume takes light from.
std::vector<std::string> PacketParts(const RenderSettings& settings)
{
  const RayPass pass = settings.pass;
  if (settings.role == ShaderRole::WriteLayerDepths)
  {
    return { "RayParameters.glsl", PeelFile(pass), "Marched/LayerDepths.frag.glsl" };
  }
  if (settings.role == ShaderRole::DimGeometry)
  {
    return { "RayParameters.glsl", "RayTextures.glsl", "MarchedPixels.glsl",
      "Marched/Factors.frag.glsl" };
  }
  std::vector<std::string> parts = { "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl",
    WindowFile(settings), "MarchedPixels.glsl" };
  if (Peels(pass))
  {
    parts.push_back(PeelFile(pass));
  }
  if (Locates(pass))
  {
    parts.push_back(LocateFile(pass));
  }
  parts.push_back(MarchedFile(pass));
  return parts;
}

// Geometry casts no shadows on itself.
std::vector<std::string> LightPlacesParts(const RenderSettings& settings)
{
  RenderSettings march = settings;
  march.role = ShaderRole::MarchRays;
  march.pass = RayPass::Whole;
  march.casters = false;
  std::vector<std::string> parts = FragmentShaderParts(march);
  const auto isOfRaysOfEye = [](const std::string& part)
  {
    const std::string slot = part.substr(0, part.find('/'));
    return slot == "Resume" || slot == "Span" || slot == "Window" || part == "RayMarch.frag.glsl";
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), isOfRaysOfEye), parts.end());
  parts.insert(parts.end(), { "MarchedPixels.glsl", "LightOnPlaces.frag.glsl" });
  return parts;
}

}
