#include "Tolerance/SearchFacts.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"
#include "Frame/SceneFingerprint.h"
#include "March/SkyParameters.h"
#include "Resources/ValueFocus.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// The coarsest sample distance, in voxels.
constexpr double CoarsestVoxels = 4.0;
// At least this many samples on the longest ray: with fewer, halving the distance would not change
// the image.
constexpr double FewestSamples = 16.0;
// At least this many samples across the thinnest piece of a volume, for the same reason: a segment
// has four samples, and one of half the length must still end in the piece. In pieces thinner than
// a quarter of a voxel, four samples suffice.
constexpr double FewestAcross = 8.0;
constexpr double LeastOfCoarsestVoxels = 1.0 / 32.0;

// The cost of a pre-integrated step, in midpoint steps. For materials, which are then linear
// between two samples, packets and shaders differ (2.1 to 2.9 with packets in seven images).
constexpr double PreIntegrationCost = 1.33;
constexpr double LinearCostOfPackets = 2.5;
constexpr double LinearCostOfShaders = 1.15;

double PreIntegrationCostOf(const VolumeMarch& march)
{
  if (!MarchesMaterial(march.settings))
  {
    return PreIntegrationCost;
  }
  return march.plan.marcher == Marcher::Processor ? LinearCostOfPackets : LinearCostOfShaders;
}

// A peak of the transfer function wider than this part of the value range is hit by more than one
// in a thousand samples, so that a trial shows it.
constexpr double NarrowPeak = 1.0 / 256.0;

// A larger optical table loses so much in its pre-integrated table that edges of the transfer
// function move, equally at every sample distance: a shorter distance would not show that error.
constexpr std::size_t MostPreIntegratedEntries = 8192;

// True if the opacity of a composite depends on the transfer function of its values alone.
bool IsOpacityOfValues(RenderSettings settings)
{
  settings.shading = false;
  return !MarchesMaterial(settings);
}

// Segments of rays to lights are as long as the square root of the sample distance, so that the
// error of light falls by the first order of it, and that of the image by one between this and the
// usual one. In occlusion that order makes searches too long.
double SupposedOrderOf(const RenderSettings& settings)
{
  constexpr double OfLight = 1.3;
  return IsInWayOfLights(settings) && !IsInWayOfSky(settings) ? OfLight : UsualOrder;
}

// Beside opaque matter the extinction rises so steeply that two longer steps miss it together.
constexpr double CoarsestBesideOpaqueVoxels = 0.25;

bool HasOpaqueMatter(const VolumeMarch& march, const VolumeResources& volume)
{
  return march.settings.blend == Blend::Composite &&
    !OpaqueValuesOf(march.frame, volume.Blocks().Texels()).empty();
}

StepRange RangeOf(const VolumeMarch& march, const VolumeResources& volume)
{
  const double voxelMm = SmallestSpacingMm(march.frame);
  double coarsestMm =
    CoarsestDistanceMm(march.frame, march.frame.cuts.boxGrid, LongestRayMm(march.frame));
  if (HasOpaqueMatter(march, volume))
  {
    coarsestMm = std::min(coarsestMm, CoarsestBesideOpaqueVoxels * voxelMm);
  }
  // The search also draws at half of the finest distance.
  const double finestMm = std::max(
    FinestStepVoxels * voxelMm, 2.0 * ShortestDistanceWithSkyMm(march.frame, march.plan.marcher));
  return { coarsestMm, std::min(finestMm, coarsestMm), !march.frame.voxelsFit,
    SupposedOrderOf(march.settings) };
}

}

double CoarsestDistanceMm(const Frame& frame, const Box& grid, double longestRayMm)
{
  const double voxelMm = SmallestSpacingMm(frame);
  const double acrossMm =
    std::max(ThinnestPieceMm(frame, grid) / FewestAcross, LeastOfCoarsestVoxels * voxelMm);
  return std::min({ CoarsestVoxels * voxelMm, longestRayMm / FewestSamples, acrossMm });
}

SearchFacts FactsOf(const VolumeMarch& march, const VolumeResources& volume)
{
  const OpticalTable& table = volume.Materials().OpticalTables().Table();
  SearchFacts facts;
  facts.limit = march.plan.budget.StepLimit();
  facts.range = RangeOf(march, volume);
  facts.firstMm = SmallestSpacingMm(march.frame);
  facts.usual = march.settings.integration;
  facts.choosesIntegration = march.plan.choosesIntegration;
  facts.preIntegratesByTable = !MarchesMaterial(march.settings);
  facts.hasLight = march.settings.shading || march.settings.occlusion;
  facts.isShaded = march.settings.shading;
  facts.tracesLight = IsInWayOfLights(march.settings) || IsInWayOfSky(march.settings);
  facts.keepsLight = volume.Light().HasLattices() || !march.frame.others.empty();
  facts.lightOfLimit = march.plan.budget.LightOfLimit();
  facts.looksForPeaks = march.settings.blend == Blend::Composite &&
    march.plan.triesPreIntegration && IsOpacityOfValues(march.settings);
  facts.losesByTable = table.entries.size() > MostPreIntegratedEntries;
  facts.mayPreIntegrate = MarchesMaterial(march.settings) || !facts.losesByTable;
  facts.preIntegrationCost = PreIntegrationCostOf(march);
  if (facts.looksForPeaks)
  {
    const ValueRange& resolved = volume.Blocks().Texels().resolved;
    const double nodeGap = march.frame.material.functions.first.SmallestNodeGap();
    facts.hasNarrowPeaks = nodeGap < NarrowPeak * (resolved.upper - resolved.lower);
    facts.hasNodesInTable = MostPreIntegratedValues * nodeGap < table.lastValue - table.firstValue;
  }
  return facts;
}

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
  return Fingerprint(march.frame.material.functions.inputs, march.plan.marcher,
    march.plan.choosesIntegration, march.settings.integration, march.plan.budget.StepTolerance(),
    march.frame.geometry.SmallestSpacingMm());
}

// The inputs of a volume that the image depends on in any view and light, besides those of the
// rule.
Fingerprint SceneInputsOf(const VolumeMarch& march)
{
  const Viewport& pixels = march.plan.viewport;
  Fingerprint inputs(march.frame.unlit, pixels.width, pixels.height, march.settings.occlusion,
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
  this->view.push_back(CornersOf(march.frame.geometry.boxGrid, march.frame.ClipFromGrid()));
}

}
