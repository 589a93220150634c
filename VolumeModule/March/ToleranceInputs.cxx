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
// A lamp is near another place if its direction has turned by no more than 15 degrees.
constexpr float CosineOfNear = 0.966f;

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

// The inputs of a volume that the image depends on in any view and light, besides those of the
// rule.
Fingerprint SceneInputsOf(const VolumeMarch& march)
{
  const Viewport& pixels = march.plan.viewport;
  Fingerprint inputs(UnlitFingerprint(march.frame), pixels.width, pixels.height,
    march.settings.occlusion, march.frame.levelRound, march.frame.image.windowScaleBias,
    march.frame.span.firstDistanceMm, march.frame.quality.variationTolerance);
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

void ToleranceLights::Add(const Frame& frame)
{
  if (!frame.settings.shading)
  {
    return;
  }
  const SceneLights& lights = frame.lights;
  this->colors.Add(
    Fingerprint(lights.areTwoSided, lights.head.diffuse, lights.head.specular, lights.ambient));
  const glm::dvec3 middle = glm::dvec3(frame.geometry.worldFromGrid *
    glm::dvec4(0.5 * (frame.geometry.boxGrid.lower + frame.geometry.boxGrid.upper), 1.0));
  for (int lamp = 0; lamp < lights.lamps.Count(); ++lamp)
  {
    const glm::vec4* const texels = &lights.lamps.texels[std::size_t(lamp) * LightTexels::PerLight];
    const bool isDistant = lamp < lights.lamps.distantCount;
    this->colors.Add(Fingerprint(isDistant, texels[0].w, texels[1], texels[2], texels[3]));
    this->places.insert(this->places.end(), { glm::vec3(texels[0]), glm::vec3(texels[4]) });
    const glm::vec3 place(texels[0]);
    this->towards.push_back(glm::normalize(isDistant ? place : place - glm::vec3(middle)));
  }
}

bool ToleranceLights::IsNear(const ToleranceLights& other) const
{
  const auto isNear = [](const glm::vec3& one, const glm::vec3& there)
  { return glm::dot(one, there) >= CosineOfNear; };
  return this->colors == other.colors &&
    std::equal(this->towards.begin(), this->towards.end(), other.towards.begin(),
      other.towards.end(), isNear);
}

void ToleranceInputs::Add(const VolumeMarch& march, const VolumeResources& volume)
{
  const std::vector<std::string> recipeOfVolume = RecipeOf(march.frame);
  this->recipe.insert(this->recipe.end(), recipeOfVolume.begin(), recipeOfVolume.end());
  this->rule.Add(RuleInputsOf(march));
  this->voxels.Add(VoxelInputsOf(march, volume));
  this->scene.Add(SceneInputsOf(march));
  this->lights.Add(march.frame);
  this->casters.Add(march.frame.casters.fingerprint);
  this->view.push_back(CornersOf(march.frame.geometry.boxGrid,
    ClipFromWorld(march.frame.view.renderer) * march.frame.geometry.worldFromGrid));
}

}
