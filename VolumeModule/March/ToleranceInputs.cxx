#include "March/ToleranceInputs.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"
#include "Frame/SceneFingerprint.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

// A view is near another if no corner of a volume has moved by more than this part of the image.
constexpr double NearMove = 0.05;

// The shader files that the request of a volume takes, whatever the march finds out about it.
std::vector<std::string> RecipeOf(const Frame& frame)
{
  RenderSettings settings = frame.settings;
  settings.pass = RayPass::Whole;
  return FragmentShaderParts(settings);
}

// The inputs of a volume that the integration rule depends on, besides its recipe and voxels.
std::vector<double> RuleInputsOf(const VolumeMarch& march)
{
  std::vector<double> inputs = MaterialTableInputs(march.frame.material.property, march.settings);
  inputs.insert(inputs.end(),
    { double(march.plan.marcher), double(march.plan.choosesIntegration),
      double(march.settings.integration), march.plan.budget.StepTolerance(),
      march.frame.geometry.SmallestSpacingMm() });
  return inputs;
}

// The inputs of a volume that the image depends on in any view, besides those of the rule.
std::vector<double> SceneInputsOf(const VolumeMarch& march)
{
  std::vector<double> inputs = march.frame.fingerprint;
  inputs.insert(inputs.end(),
    { double(march.plan.viewport.width), double(march.plan.viewport.height),
      double(march.settings.occlusion), double(march.frame.levelRound),
      march.frame.image.windowScaleBias.x, march.frame.image.windowScaleBias.y,
      march.frame.span.firstDistanceMm });
  // Lights and geometry stay where they are in the world when a volume moves with its view.
  if (march.settings.shadows)
  {
    const glm::dmat4& world = march.frame.geometry.worldFromGrid;
    inputs.insert(inputs.end(), glm::value_ptr(world), glm::value_ptr(world) + 16);
  }
  return inputs;
}

// The voxels that are drawn, and the values that tables tell apart, which may depend on the look of
// earlier images.
std::vector<double> VoxelInputsOf(const VolumeMarch& march, const VolumeResources& volume)
{
  std::vector<double> inputs = VoxelFingerprint(march.frame.voxels);
  for (const ScalarTexels& texels : volume.Blocks().TexelsOfComponents())
  {
    inputs.insert(inputs.end(), { texels.resolved.lower, texels.resolved.upper });
  }
  return inputs;
}

}

bool ToleranceInputs::HasViewNear(const ToleranceInputs& other) const
{
  if (this->view.size() != other.view.size())
  {
    return false;
  }
  double moved = 0.0;
  for (std::size_t i = 0; i < this->view.size(); ++i)
  {
    moved = std::max(moved, LargestMove(this->view[i], other.view[i]));
  }
  return moved <= NearMove;
}

void ToleranceInputs::Add(const VolumeMarch& march, const VolumeResources& volume)
{
  const auto append = [](auto& inputs, const auto& more)
  { inputs.insert(inputs.end(), more.begin(), more.end()); };
  append(this->recipe, RecipeOf(march.frame));
  append(this->rule, RuleInputsOf(march));
  append(this->voxels, VoxelInputsOf(march, volume));
  append(this->scene, SceneInputsOf(march));
  append(this->casters, march.frame.casters.fingerprint);
  this->view.push_back(CornersOf(march.frame.geometry.boxGrid,
    ClipFromWorld(march.frame.view.renderer) * march.frame.geometry.worldFromGrid));
}

}
