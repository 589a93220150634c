// The search draws some of the rays of an image at several sample distances, which shows the error
// of each distance.

#include "March/ToleranceSearch.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Frame/FrameMeasures.h"
#include "Frame/PropertyTransferFunction.h"
#include "March/SkyParameters.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The range of sample distances, in voxels.
constexpr double CoarsestVoxels = 4.0;
constexpr double FinestVoxels = 1.0 / 128.0;
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

// The factor by which pre-integration must reduce the error at the same sample distance, so that
// its steps may be longer by the ratio of the costs.
double GainThatPays(const VolumeMarch& march)
{
  constexpr double Order = 1.6;
  return std::pow(PreIntegrationCostOf(march), Order);
}

// A peak of the transfer function wider than this part of the value range is hit by more than one
// in a thousand samples, so that a trial shows it.
constexpr double NarrowPeak = 1.0 / 256.0;

// A larger optical table loses so much in its pre-integrated table that edges of the transfer
// function move, equally at every sample distance: a shorter distance would not show that error.
constexpr std::size_t MostPreIntegratedEntries = 8192;

bool LosesByPreIntegration(const VolumeResources& volume)
{
  return volume.Materials().OpticalTables().Table().entries.size() > MostPreIntegratedEntries;
}

// A pre-integrated table hits or misses nodes that lie closer together than its values by chance,
// and so does the table of half as many: their difference has been 1/3.5 of the error.
constexpr double MostByChance = 4.0;

bool HasNodesBetweenTableValues(const VolumeMarch& march, const VolumeResources& volume)
{
  const OpticalTable& table = volume.Materials().OpticalTables().Table();
  return MostPreIntegratedValues *
    TransferFunctionOf(march.frame.material.property).SmallestNodeGap() <
    table.lastValue - table.firstValue;
}

// A pre-integrated table has 1024 values on a side, which also moves edges: a difference below this
// many times the limit may be an error of the table.
constexpr double CertainlyMissed = 4.0;

// The factor of the steps of another view nearby.
constexpr double NearbyPart = 0.9;

// The number of earlier choices that are remembered: enough for a scan with many times.
constexpr std::size_t MostRemembered = 128;

// The image with its colours set to 0: opacity does not depend on light.
std::vector<float> OpacityOf(std::vector<float> picture)
{
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    picture[i] = i % 4 == 3 ? picture[i] : 0.0f;
  }
  return picture;
}

// Raises the estimated error to at least that of the peaks that the rule is known to miss.
ToleranceChoice WithMissed(ToleranceChoice choice, double missedOfLimit, const ErrorLimit& limit)
{
  choice.missedOfLimit = missedOfLimit;
  choice.step.ofLimit = std::max(choice.step.ofLimit, missedOfLimit);
  choice.step.error = std::max(choice.step.error, missedOfLimit * limit.percentile999);
  return choice;
}

// True if the opacity of a composite depends on the transfer function of its values alone.
bool IsOpacityOfValues(RenderSettings settings)
{
  settings.shading = false;
  return !MarchesMaterial(settings);
}

StepRange RangeOf(const VolumeMarch& march)
{
  const double voxelMm = SmallestSpacingMm(march.frame);
  const double acrossMm =
    std::max(ThinnestPieceMm(march.frame) / FewestAcross, LeastOfCoarsestVoxels * voxelMm);
  const double coarsestMm =
    std::min({ CoarsestVoxels * voxelMm, LongestRayMm(march.frame) / FewestSamples, acrossMm });
  // The search also draws at half of the finest distance.
  const double finestMm = std::max(
    FinestVoxels * voxelMm, 2.0 * ShortestDistanceWithSkyMm(march.frame, march.plan.marcher));
  return { coarsestMm, std::min(finestMm, coarsestMm) };
}

}

void ToleranceSearch::Forget()
{
  this->choice.reset();
  this->remembered.clear();
}

// While the view moves, a choice is reused for nearby views. A view at rest gets a choice of its
// own, and so does geometry.
bool ToleranceSearch::Serves(const ToleranceChoice& made, const ToleranceInputs& inputs) const
{
  const bool isForMotion = made.isOfOtherCasters && this->viewRests && this->castersRest;
  return this->viewRests ? made.inputs == inputs && !isForMotion : made.inputs.IsNear(inputs);
}

bool ToleranceSearch::TakeRemembered(const ToleranceInputs& inputs)
{
  const auto serves = [&](const ToleranceChoice& made) { return this->Serves(made, inputs); };
  const auto isOfImage = [&](const ToleranceChoice& made)
  { return made.inputs == inputs && serves(made); };
  auto found = std::find_if(this->remembered.begin(), this->remembered.end(), isOfImage);
  if (found == this->remembered.end())
  {
    found = std::find_if(this->remembered.begin(), this->remembered.end(), serves);
  }
  if (found == this->remembered.end())
  {
    return false;
  }
  ToleranceChoice taken = std::move(*found);
  this->remembered.erase(found);
  this->Remember();
  this->choice = std::move(taken);
  return true;
}

void ToleranceSearch::Remember()
{
  if (this->choice)
  {
    this->remembered.push_front(std::move(*this->choice));
    this->choice.reset();
  }
  if (this->remembered.size() > MostRemembered)
  {
    this->remembered.pop_back();
  }
}

void ToleranceSearch::Update(const VolumeMarch& march, const VolumeResources& volume,
  const ToleranceInputs& inputs, const TrialDrawing& draw)
{
  if (BeginsPicture(march.plan.pass))
  {
    this->BeginImage(inputs);
  }
  this->view = inputs.view;
  const bool serves = this->choice && this->Serves(*this->choice, inputs);
  const Trial trial{ march, volume, draw, march.plan.budget.StepLimit(),
    TrialPixels(march.plan.viewport) };
  if (!serves && !this->TakeRemembered(inputs) && !this->KeepBesideMovedCasters(trial, inputs))
  {
    ToleranceChoice made = this->ChooseSteps(trial, inputs);
    this->Remember();
    this->choice = std::move(made);
    ++this->searches;
  }
}

double ToleranceSearch::SampleDistanceInViewMm() const
{
  const StepChoice& step = this->choice->step;
  return this->choice->inputs.view == this->view ? step.sampleDistance
                                                 : NearbyPart * step.sampleDistance;
}

const std::vector<float>& ToleranceSearch::Trial::Draw(
  Integration integration, double sampleDistanceMm)
{
  return this->DrawOnce(true, integration, sampleDistanceMm);
}

const std::vector<float>& ToleranceSearch::Trial::DrawUnlit(
  Integration integration, double sampleDistanceMm)
{
  const bool hasLight = this->march.settings.shading || this->march.settings.occlusion;
  return this->DrawOnce(!hasLight, integration, sampleDistanceMm);
}

std::vector<float> ToleranceSearch::Trial::DrawWithSmallTable(double sampleDistanceMm)
{
  MarchPlan tried = this->PlanOf(false, Integration::PreIntegrated, sampleDistanceMm);
  tried.hasSmallTable = true;
  return this->draw(tried);
}

const std::vector<float>& ToleranceSearch::Trial::DrawOnce(
  bool isLit, Integration integration, double distanceMm)
{
  std::vector<float>& image = this->drawn[{ isLit, integration, distanceMm }];
  if (image.empty())
  {
    image = this->draw(this->PlanOf(isLit, integration, distanceMm));
  }
  return image;
}

MarchPlan ToleranceSearch::Trial::PlanOf(
  bool isLit, Integration integration, double distanceMm) const
{
  MarchPlan tried = this->march.plan.WithViewport(this->pixels);
  tried.pass = RayPass::Whole;
  tried.integration = integration;
  tried.sampleDistanceMm = distanceMm;
  tried.isTrial = true;
  tried.isLit = isLit;
  return tried;
}

FoundSteps ToleranceSearch::Trial::Find(
  Integration integration, double firstMm, const std::vector<float>& exact)
{
  const auto drawAt = [&](double sampleDistanceMm)
  { return this->Draw(integration, sampleDistanceMm); };
  return FindSampleDistance(drawAt, this->limit, RangeOf(this->march), firstMm, exact);
}

FoundSteps ToleranceSearch::Trial::FindFrom(Integration integration, double earlierMm)
{
  const auto drawAt = [&](double sampleDistanceMm)
  { return this->Draw(integration, sampleDistanceMm); };
  return FindSampleDistanceFrom(
    earlierMm, drawAt, this->limit, RangeOf(this->march), SmallestSpacingMm(this->march.frame));
}

ToleranceChoice ToleranceSearch::ChoiceOf(
  Trial& trial, const ToleranceInputs& inputs, Integration integration, const FoundSteps& found)
{
  const ToleranceChoice choice{ inputs, integration, found.choice };
  return WithMissed(choice, MissedOfLimit(trial, choice), trial.limit);
}

// The rule is chosen again only for another transfer function or volume, not while a camera moves.
// While every image has new voxels, the last rule and its distance are tried first.
std::optional<ToleranceChoice> ToleranceSearch::ChooseByLastRule(
  Trial& trial, const ToleranceInputs& inputs) const
{
  const bool hasRule = this->choice && this->choice->inputs.HasRuleOf(inputs);
  if (hasRule && this->choice->inputs.voxels == inputs.voxels)
  {
    const FoundSteps found =
      trial.Find(this->choice->integration, SmallestSpacingMm(trial.march.frame));
    return WithMissed({ inputs, this->choice->integration, found.choice },
      this->choice->missedOfLimit, trial.limit);
  }
  if (!hasRule || !this->isSeries)
  {
    return std::nullopt;
  }
  const FoundSteps found =
    trial.FindFrom(this->choice->integration, this->choice->step.sampleDistance);
  const ToleranceChoice made = ChoiceOf(trial, inputs, this->choice->integration, found);
  const bool isNoWorse = made.step.KeepsLimit() || !this->choice->step.KeepsLimit();
  return isNoWorse ? std::optional<ToleranceChoice>(made) : std::nullopt;
}

ToleranceChoice ToleranceSearch::ChooseSteps(Trial trial, const ToleranceInputs& inputs) const
{
  if (const std::optional<ToleranceChoice> made = this->ChooseByLastRule(trial, inputs))
  {
    return *made;
  }
  // Each search begins at the same distance, so that its result does not depend on an earlier one.
  const double firstMm = SmallestSpacingMm(trial.march.frame);
  const Integration usual = trial.march.settings.integration;
  const FoundSteps found = trial.Find(usual, firstMm);
  const ToleranceChoice choice = ChoiceOf(trial, inputs, usual, found);
  if (!trial.march.plan.choosesIntegration || !PreIntegrationMayPay(trial, choice, found.finest))
  {
    return choice;
  }
  constexpr Integration Other = Integration::PreIntegrated;
  const ToleranceChoice preIntegrated = ChoiceOf(trial, inputs, Other,
    choice.step.KeepsLimit() ? trial.Find(Other, choice.step.sampleDistance, found.finest)
                             : trial.Find(Other, firstMm));
  return IsBetter(preIntegrated.step, PreIntegrationCostOf(trial.march), choice.step)
    ? preIntegrated
    : choice;
}

// The error of pre-integration at the chosen distance decides, since it takes one image where a
// search takes several. It is measured against the finest image, to which all rules converge.
bool ToleranceSearch::PreIntegrationMayPay(
  Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest)
{
  if (choice.missedOfLimit > 0.0)
  {
    return true;
  }
  const bool losesTooMuch =
    !MarchesMaterial(trial.march.settings) && LosesByPreIntegration(trial.volume);
  if (losesTooMuch || !choice.step.KeepsLimit())
  {
    return !losesTooMuch;
  }
  const double distanceMm = choice.step.sampleDistance;
  if (distanceMm >= RangeOf(trial.march).coarsest)
  {
    return false;
  }
  const std::vector<float> image = trial.Draw(Integration::PreIntegrated, distanceMm);
  return GainThatPays(trial.march) * ErrorOfLimit(image, finest, trial.limit) < 1.0;
}

// A shorter distance reveals neither a peak that lies between all samples nor what the table of a
// pre-integration loses.
double ToleranceSearch::MissedOfLimit(Trial& trial, const ToleranceChoice& choice)
{
  if (trial.march.settings.blend != Blend::Composite || !trial.march.plan.triesPreIntegration ||
    !IsOpacityOfValues(trial.march.settings))
  {
    return 0.0;
  }
  if (choice.integration == Integration::PreIntegrated && !trial.march.settings.shading)
  {
    return LostOfLimit(trial, choice.step.sampleDistance);
  }
  const ValueRange& resolved = trial.volume.Blocks().Texels().resolved;
  const double range = resolved.upper - resolved.lower;
  const bool hasNarrowPeaks =
    TransferFunctionOf(trial.march.frame.material.property).SmallestNodeGap() < NarrowPeak * range;
  return hasNarrowPeaks ? MissedPeaksOfLimit(trial, choice) : 0.0;
}

// Pre-integration misses no peak: its difference from the sampled image, less the errors of its own
// steps and table, is therefore an error of sampling.
double ToleranceSearch::MissedPeaksOfLimit(Trial& trial, const ToleranceChoice& choice)
{
  const double distanceMm = choice.step.sampleDistance;
  const std::vector<float> steps = OpacityOf(trial.Draw(choice.integration, distanceMm));
  const std::vector<float> coarse =
    OpacityOf(trial.DrawUnlit(Integration::PreIntegrated, distanceMm));
  const std::vector<float> fine =
    OpacityOf(trial.DrawUnlit(Integration::PreIntegrated, 0.5 * distanceMm));
  const double difference =
    DifferenceOfLimit(steps, fine, trial.limit) - DifferenceOfLimit(coarse, fine, trial.limit);
  if (difference <= CertainlyMissed)
  {
    return 0.0;
  }
  const double missed = difference - LostOfLimit(trial, 0.5 * distanceMm);
  return missed > CertainlyMissed ? missed : 0.0;
}

// The error of a pre-integrated table falls at least in proportion to the distance of its values:
// a table of half as many differs by the error or more, unless nodes lie between its values.
double ToleranceSearch::LostOfLimit(Trial& trial, double distanceMm)
{
  if (!LosesByPreIntegration(trial.volume))
  {
    return 0.0;
  }
  const double difference = DifferenceOfLimit(trial.DrawWithSmallTable(distanceMm),
    trial.DrawUnlit(Integration::PreIntegrated, distanceMm), trial.limit);
  return HasNodesBetweenTableValues(trial.march, trial.volume) ? MostByChance * difference
                                                               : difference;
}

}
