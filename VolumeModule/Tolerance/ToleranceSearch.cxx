// The search draws some of the rays of an image at several sample distances, which shows the error
// of each distance.

#include "Tolerance/ToleranceSearch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// The factor by which pre-integration must reduce the error at the same sample distance, so that
// its steps may be longer by the ratio of the costs.
double GainThatPays(const SearchFacts& facts)
{
  constexpr double Order = 1.6;
  return std::pow(facts.preIntegrationCost, Order);
}

// A pre-integrated table hits or misses nodes that lie closer together than its values by chance,
// and so does the table of half as many: their difference has been 1/3.5 of the error.
constexpr double MostByChance = 4.0;

// A pre-integrated table has 1024 values on a side, which also moves edges: a difference below this
// many times the limit may be an error of the table.
constexpr double CertainlyMissed = 4.0;

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

}

void ToleranceSearch::Forget()
{
  this->choice.reset();
  this->remembered.clear();
}

// An image at rest gets a search of its own.
bool ToleranceSearch::Serves(const ToleranceChoice& made, const ToleranceInputs& inputs) const
{
  return made.inputs == inputs && !(made.isOfOther && this->IsAtRest());
}

bool ToleranceSearch::TakeRemembered(const ToleranceInputs& inputs)
{
  const auto serves = [&](const ToleranceChoice& made) { return this->Serves(made, inputs); };
  const auto found = std::find_if(this->remembered.begin(), this->remembered.end(), serves);
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
  if (serves || this->TakeRemembered(inputs))
  {
    return;
  }
  const SearchFacts facts = FactsOf(march, volume);
  const Trial trial{ facts, { facts, draw } };
  std::optional<ToleranceChoice> made = this->KeptChoice(trial, inputs);
  if (!made)
  {
    made = this->ChooseSteps(trial, inputs);
    ++this->searches;
  }
  this->Remember();
  this->choice = std::move(made);
}

void ToleranceSearch::Take(const ToleranceInputs& inputs, ToleranceChoice made)
{
  made.inputs = inputs;
  made.searchedMm = made.step.sampleDistance;
  made.searchedView = inputs.view;
  made.searchedLights = inputs.lights;
  this->Remember();
  this->choice = std::move(made);
  ++this->searches;
}

const std::vector<float>& ToleranceSearch::Trial::Draw(
  Integration integration, double sampleDistanceMm)
{
  return this->images.Of(
    { integration, sampleDistanceMm, true, false, this->isSmall, this->light });
}

const std::vector<float>& ToleranceSearch::Trial::DrawUnlit(
  Integration integration, double sampleDistanceMm)
{
  return this->images.Of(
    { integration, sampleDistanceMm, !this->facts.hasLight, false, this->isSmall, {} });
}

const std::vector<float>& ToleranceSearch::Trial::DrawWithSmallTable(double sampleDistanceMm)
{
  return this->images.Of(
    { Integration::PreIntegrated, sampleDistanceMm, false, true, this->isSmall, {} });
}

FoundSteps ToleranceSearch::Trial::Find(
  Integration integration, double firstMm, const std::vector<float>& exact)
{
  const auto drawAt = [&](double sampleDistanceMm)
  { return this->Draw(integration, sampleDistanceMm); };
  return FindSampleDistance(drawAt, this->facts.limit, this->facts.range, firstMm, exact);
}

FoundSteps ToleranceSearch::Trial::FindFrom(Integration integration, double earlierMm)
{
  const auto drawAt = [&](double sampleDistanceMm)
  { return this->Draw(integration, sampleDistanceMm); };
  return FindSampleDistanceFrom(
    earlierMm, drawAt, this->facts.limit, this->facts.range, this->facts.firstMm);
}

StepChoice ToleranceSearch::Trial::FirstThatKeeps(
  Integration integration, const std::vector<double>& distancesMm)
{
  const auto drawAt = [&](double distanceMm) { return this->Draw(integration, distanceMm); };
  return varimarch::FirstThatKeeps(
    distancesMm, drawAt, this->facts.limit, this->facts.range, this->facts.firstMm);
}

ToleranceChoice ToleranceSearch::ChoiceOf(
  Trial& trial, const ToleranceInputs& inputs, Integration integration, const FoundSteps& found)
{
  const StepChoice& step = found.choice;
  return WithMissed(trial,
    { inputs, integration, step, 0.0, {}, step.sampleDistance, inputs.view, inputs.lights, false });
}

ToleranceChoice ToleranceSearch::WithMissed(Trial& trial, ToleranceChoice choice)
{
  const double missedOfLimit = MissedOfLimit(trial, choice);
  choice.missedOfLimit = missedOfLimit;
  choice.step.ofLimit = std::max(choice.step.ofLimit, missedOfLimit);
  choice.step.error = std::max(choice.step.error, missedOfLimit * trial.facts.limit.percentile999);
  return choice;
}

// Where the last rule keeps the limit, it is chosen again only for another transfer function or
// volume, not while a camera moves. While every image has new voxels, the last rule and its
// distance are tried first.
std::optional<ToleranceChoice> ToleranceSearch::ChooseByLastRule(
  Trial& trial, const ToleranceInputs& inputs) const
{
  const bool hasRule = this->choice && this->choice->inputs.HasRuleOf(inputs);
  const bool hasVoxels = hasRule && this->choice->inputs.voxels == inputs.voxels;
  if (!hasRule || !(hasVoxels || this->isSeries))
  {
    return std::nullopt;
  }
  const Integration rule = this->choice->integration;
  const FoundSteps found = hasVoxels ? trial.Find(rule, trial.facts.firstMm)
                                     : trial.FindFrom(rule, this->choice->step.sampleDistance);
  const ToleranceChoice made = ChoiceOf(trial, inputs, rule, found);
  const bool isNoWorse = made.step.KeepsLimit() || !this->choice->step.KeepsLimit();
  return isNoWorse ? std::optional<ToleranceChoice>(made) : std::nullopt;
}

// All trial images of a search with lattices share their error. So one image more is drawn without
// them, with the light of steps that are shorter by the factor at which a search compares images.
// Where lattices are not exact enough, others of their light ask for other steps.
template <class Choose>
ToleranceChoice ToleranceSearch::ChooseWithLight(Trial& trial, Choose choose)
{
  const auto chooseIn = [&](const LightSource& light)
  {
    trial.light = light;
    ToleranceChoice choice = choose(trial);
    choice.light = light;
    return choice;
  };
  ToleranceChoice choice = chooseIn({});
  if (!trial.facts.tracesLight)
  {
    return choice;
  }
  const double most = trial.facts.lightOfLimit;
  double ofLimit = trial.facts.keepsLight ? KeptLightOfLimit(trial, choice) : 0.0;
  if (ofLimit > most)
  {
    const std::optional<LightSource> exact = ExactLight(trial, choice, ofLimit);
    choice = exact ? chooseIn(*exact) : choice;
    ofLimit = exact ? KeptLightOfLimit(trial, choice) : ofLimit;
  }
  if (ofLimit > most)
  {
    choice = chooseIn({ 0.0, 0.0 });
    ofLimit = 0.0;
  }
  ofLimit = LengthenLight(trial, choice, ofLimit);
  choice.step.error += ofLimit * trial.facts.limit.percentile999;
  return choice;
}

double ToleranceSearch::LengthenLight(Trial& trial, ToleranceChoice& choice, double ofLimit)
{
  // Voxels that are read anew for each pass over the rays take longer than the steps.
  if (!choice.step.KeepsLimit() || trial.facts.range.isOfHalfOctaves)
  {
    return ofLimit;
  }
  ToleranceChoice longer = choice;
  for (const double factor : { 4.0, 16.0 })
  {
    longer.light.sampleDistanceMm = factor * choice.step.sampleDistance;
    if (longer.light.sampleDistanceMm > trial.facts.range.coarsest)
    {
      break;
    }
    const double ofLonger = KeptLightOfLimit(trial, longer);
    if (ofLonger > trial.facts.lightOfLimit)
    {
      break;
    }
    choice.light = longer.light;
    ofLimit = ofLonger;
  }
  return ofLimit;
}

// The error falls with the differences that are allowed between the nodes of a cell, unless the
// light is wrong at the nodes themselves.
std::optional<LightSource> ToleranceSearch::ExactLight(
  Trial& trial, ToleranceChoice choice, double ofLimit)
{
  constexpr double LeastPart = 1.0 / 32.0;
  constexpr double Caution = 0.6; // the error falls less than the differences
  constexpr double LargestCut = 1.0 / 8.0;
  constexpr double LeastGain = 0.7;
  const double most = trial.facts.lightOfLimit;
  while (ofLimit > most && choice.light.latticePart > LeastPart)
  {
    choice.light.latticePart *= std::max(Caution * most / ofLimit, LargestCut);
    const double last = ofLimit;
    ofLimit = KeptLightOfLimit(trial, choice);
    if (ofLimit > LeastGain * last)
    {
      break; // the nodes are wrong
    }
  }
  return ofLimit <= most ? std::optional<LightSource>(choice.light) : std::nullopt;
}

double ToleranceSearch::KeptLightOfLimit(Trial& trial, const ToleranceChoice& choice)
{
  constexpr double Finer = 4.0;
  const double distanceMm = choice.step.sampleDistance;
  const auto drawIn = [&](const LightSource& light)
  {
    trial.light = light;
    return trial.Draw(choice.integration, distanceMm);
  };
  const std::vector<float> kept = drawIn(choice.light);
  const std::vector<float> traced = drawIn({ 0.0, distanceMm / Finer });
  return DifferenceOfLimit(kept, traced, trial.facts.limit);
}

ToleranceChoice ToleranceSearch::ChooseSteps(Trial trial, const ToleranceInputs& inputs) const
{
  return ChooseWithLight(trial,
    [&](Trial& tried)
    {
      const std::optional<ToleranceChoice> made = this->ChooseByLastRule(tried, inputs);
      return made ? *made : ChooseAnew(tried, inputs);
    });
}

ToleranceChoice ToleranceSearch::ChooseAnew(const SearchFacts& facts, const TrialDrawing& draw)
{
  Trial trial{ facts, { facts, draw } };
  return ChooseWithLight(trial, [&](Trial& tried) { return ChooseAnew(tried, {}); });
}

ToleranceChoice ToleranceSearch::ChooseAnew(Trial& trial, const ToleranceInputs& inputs)
{
  // Each search begins at the same distance, so that its result does not depend on an earlier one.
  const double firstMm = trial.facts.firstMm;
  const Integration usual = trial.facts.usual;
  const FoundSteps found = trial.Find(usual, firstMm);
  const ToleranceChoice choice = ChoiceOf(trial, inputs, usual, found);
  if (!trial.facts.choosesIntegration || !PreIntegrationMayPay(trial, choice, found.finest))
  {
    return choice;
  }
  constexpr Integration Other = Integration::PreIntegrated;
  const ToleranceChoice preIntegrated = ChoiceOf(trial, inputs, Other,
    choice.step.KeepsLimit() ? trial.Find(Other, choice.step.sampleDistance, found.finest)
                             : trial.Find(Other, firstMm));
  return IsBetter(preIntegrated.step, trial.facts.preIntegrationCost, choice.step) ? preIntegrated
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
  if (!trial.facts.mayPreIntegrate || !choice.step.KeepsLimit())
  {
    return trial.facts.mayPreIntegrate;
  }
  const double distanceMm = choice.step.sampleDistance;
  // Voxels that are read anew for each pass over the rays take longer than the steps.
  if (distanceMm >= trial.facts.range.coarsest || trial.facts.range.isOfHalfOctaves)
  {
    return false;
  }
  const std::vector<float> image = trial.Draw(Integration::PreIntegrated, distanceMm);
  return GainThatPays(trial.facts) * ErrorOfLimit(image, finest, trial.facts.limit) < 1.0;
}

// A shorter distance reveals neither a peak that lies between all samples nor what the table of a
// pre-integration loses.
double ToleranceSearch::MissedOfLimit(Trial& trial, const ToleranceChoice& choice)
{
  if (!trial.facts.looksForPeaks)
  {
    return 0.0;
  }
  if (choice.integration == Integration::PreIntegrated && !trial.facts.isShaded)
  {
    return LostOfLimit(trial, choice.step.sampleDistance);
  }
  return trial.facts.hasNarrowPeaks ? MissedPeaksOfLimit(trial, choice) : 0.0;
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
  const double difference = DifferenceOfLimit(steps, fine, trial.facts.limit) -
    DifferenceOfLimit(coarse, fine, trial.facts.limit);
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
  if (!trial.facts.losesByTable)
  {
    return 0.0;
  }
  const double difference = DifferenceOfLimit(trial.DrawWithSmallTable(distanceMm),
    trial.DrawUnlit(Integration::PreIntegrated, distanceMm), trial.facts.limit);
  return trial.facts.hasNodesInTable ? MostByChance * difference : difference;
}

namespace
{

// The parts of the distance of a search that are tried in another image.
constexpr std::array<double, 2> TriedParts = { 1.0, 0.9 };

}

void ToleranceSearch::BeginImage(const ToleranceInputs& inputs)
{
  this->viewRests = inputs.view == this->view;
  this->lightsRest = inputs.lights == this->lights;
  this->lights = inputs.lights;
  this->castersRest = inputs.casters == this->casters;
  this->casters = inputs.casters;
  const bool areNew = !this->voxels.IsEmpty() && inputs.voxels != this->voxels;
  this->isSeries = areNew && this->voxelsWereNew;
  this->voxelsWereNew = areNew;
  this->voxels = inputs.voxels;
}

// The light of lattices that a search has found exact enough is compared with traced light again.
bool ToleranceSearch::KeepsLight(Trial& trial, ToleranceChoice& choice)
{
  const bool isInterpolated = trial.facts.keepsLight && !choice.light.IsTraced();
  if (!isInterpolated && !(choice.light.sampleDistanceMm > 0.0))
  {
    return true;
  }
  const double ofLimit = KeptLightOfLimit(trial, choice);
  choice.step.error += ofLimit * trial.facts.limit.percentile999;
  return ofLimit <= trial.facts.lightOfLimit;
}

const ToleranceChoice* ToleranceSearch::NearbyChoice(const ToleranceInputs& inputs) const
{
  const auto isNearby = [&](const ToleranceChoice& made)
  {
    return made.inputs.HasVolumesOf(inputs) && IsNear(made.searchedView, inputs.view) &&
      made.searchedLights.IsNear(inputs.lights);
  };
  if (this->choice && isNearby(*this->choice))
  {
    return &*this->choice;
  }
  const auto found = std::find_if(this->remembered.begin(), this->remembered.end(), isNearby);
  return found == this->remembered.end() ? nullptr : &*found;
}

// A nearby view shows almost the same, a light that moves changes how bright it is, and geometry
// that moves changes the image at the edges of its shadows, where packets bisect. A quarter of the
// rays of a search tell whether its steps still keep the limit; if they did not, those of another
// search are not better.
std::optional<ToleranceChoice> ToleranceSearch::KeptChoice(
  Trial trial, const ToleranceInputs& inputs) const
{
  const ToleranceChoice* const earlier = this->IsAtRest() ? nullptr : this->NearbyChoice(inputs);
  if (!earlier)
  {
    return std::nullopt;
  }
  trial.isSmall = true;
  trial.light = earlier->light;
  ToleranceChoice kept = *earlier;
  kept.inputs = inputs;
  kept.isOfOther = true;
  kept.step = trial.FirstThatKeeps(
    kept.integration, { TriedParts[0] * kept.searchedMm, TriedParts[1] * kept.searchedMm });
  kept = WithMissed(trial, kept);
  const bool isNoWorse = kept.step.KeepsLimit() || !earlier->step.KeepsLimit();
  return isNoWorse && KeepsLight(trial, kept) ? std::optional<ToleranceChoice>(kept) : std::nullopt;
}

}
