#include "March/SearchFacts.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Frame/FrameMeasures.h"
#include "Frame/PropertyTransferFunction.h"
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
    const double nodeGap = TransferFunctionOf(march.frame.material.property).SmallestNodeGap();
    facts.hasNarrowPeaks = nodeGap < NarrowPeak * (resolved.upper - resolved.lower);
    facts.hasNodesInTable = MostPreIntegratedValues * nodeGap < table.lastValue - table.firstValue;
  }
  return facts;
}

}
