// The steps that a ToleranceSearch keeps while a view or geometry moves.

#include "March/ToleranceSearch.h"

#include <algorithm>
#include <array>

namespace varimarch
{

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
