#include "March/ToleranceInputs.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"
#include "Frame/SceneFingerprint.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// A view is near another if no corner of a volume has moved by more than this part of the image.
constexpr double NearMove = 0.15;

// The shader files that the request of a volume takes, whatever the march finds out about it.
std::vector<std::string> RecipeOf(const Frame& frame)
{
  RenderSettings settings = frame.settings;
  settings.pass = RayPass::Whole;
  return FragmentShaderParts(settings);
}

// The inputs of a volume that the integration rule depends on, besides its recipe and voxels.
Fingerprint RuleInputsOf(const VolumeMarch& march)
{
  return Fingerprint(MaterialTableInputs(march.frame.material.property, march.settings),
    march.plan.marcher, march.plan.choosesIntegration, march.settings.integration,
    march.plan.budget.StepTolerance(), march.frame.geometry.SmallestSpacingMm());
}

// The inputs of a volume that the image depends on in any view, besides those of the rule.
Fingerprint SceneInputsOf(const VolumeMarch& march)
{
  const Viewport& pixels = march.plan.viewport;
  Fingerprint inputs(march.frame.fingerprint, pixels.width, pixels.height, march.settings.occlusion,
    march.frame.levelRound, march.frame.image.windowScaleBias, march.frame.span.firstDistanceMm,
    march.frame.quality.variationTolerance);
  // Lights and geometry stay where they are in the world when a volume moves with its view.
  if (march.settings.lights)
  {
    inputs.Add(march.frame.geometry.worldFromGrid);
  }
  return inputs;
}

// The voxels that are drawn, and the values that tables tell apart, which may depend on the look of
// earlier images.
Fingerprint VoxelInputsOf(const VolumeMarch& march, const VolumeResources& volume)
{
  Fingerprint inputs = VoxelFingerprint(march.frame);
  for (const ScalarTexels& texels : volume.Blocks().TexelsOfComponents())
  {
    inputs.Add(Fingerprint(texels.resolved.lower, texels.resolved.upper));
  }
  return inputs;
}

}

bool IsNear(const std::vector<CornersClip>& view, const std::vector<CornersClip>& other)
{
  const auto isNear = [](const CornersClip& one, const CornersClip& there)
  { return LargestMove(one, there) <= NearMove; };
  return std::equal(view.begin(), view.end(), other.begin(), other.end(), isNear);
}

void ToleranceInputs::Add(const VolumeMarch& march, const VolumeResources& volume)
{
  const std::vector<std::string> recipeOfVolume = RecipeOf(march.frame);
  this->recipe.insert(this->recipe.end(), recipeOfVolume.begin(), recipeOfVolume.end());
  this->rule.Add(RuleInputsOf(march));
  this->voxels.Add(VoxelInputsOf(march, volume));
  this->scene.Add(SceneInputsOf(march));
  this->casters.Add(march.frame.casters.fingerprint);
  this->view.push_back(CornersOf(march.frame.geometry.boxGrid,
    ClipFromWorld(march.frame.view.renderer) * march.frame.geometry.worldFromGrid));
}

}
