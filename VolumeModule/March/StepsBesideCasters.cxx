// The steps that a ToleranceSearch keeps while geometry moves.

#include "March/ToleranceSearch.h"

namespace varimarch
{

void ToleranceSearch::BeginImage(const ToleranceInputs& inputs)
{
  this->viewRests = inputs.view == this->view;
  this->castersRest = inputs.casters == this->casters;
  this->casters = inputs.casters;
  const bool areNew = !this->voxels.IsEmpty() && inputs.voxels != this->voxels;
  this->isSeries = areNew && this->voxelsWereNew;
  this->voxelsWereNew = areNew;
  this->voxels = inputs.voxels;
}

// Geometry that moves changes the image at the edges of its shadows, where packets bisect, and
// nothing else that the steps follow from. A quarter of the rays of a search tell whether its steps
// still keep the limit.
bool ToleranceSearch::KeepBesideMovedCasters(Trial trial, const ToleranceInputs& inputs)
{
  const bool mayKeep = this->choice && !this->castersRest && this->choice->step.KeepsLimit() &&
    this->choice->inputs.HasVolumesOf(inputs) && this->choice->inputs.HasViewNear(inputs);
  if (!mayKeep)
  {
    return false;
  }
  trial.isSmall = true;
  trial.light = this->choice->light;
  const Integration rule = this->choice->integration;
  const double distanceMm = this->choice->step.sampleDistance;
  if (ErrorOfLimit(
        trial.Draw(rule, distanceMm), trial.Draw(rule, distanceMm / 4.0), trial.facts.limit) > 1.0)
  {
    return false;
  }
  this->choice->inputs = inputs;
  this->choice->isOfOtherCasters = true;
  return true;
}

}
