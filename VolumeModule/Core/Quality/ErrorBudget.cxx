#include "Core/Quality/ErrorBudget.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The part of the tolerance that applies before window and level. A window narrower than the range
// of colours magnifies their errors.
double BeforeWindow(double share, double windowScale)
{
  return share / std::max(1.0, std::abs(windowScale));
}

}

double ErrorBudget::FieldError() const
{
  const double withoutTolerance = this->isExtreme ? 0.0 : FieldErrorWithoutTolerance;
  const double error = this->HasTolerance()
    ? BeforeWindow(FieldShare, this->windowScale) * this->tolerance
    : withoutTolerance;
  return error / double(this->volumeCount);
}

double ErrorBudget::LightError() const
{
  return this->HasTolerance() ? BeforeWindow(FieldShare, this->windowScale) * this->tolerance : 0.0;
}

double ErrorBudget::EarlyTermination(double withoutTolerance) const
{
  return this->HasTolerance()
    ? BeforeWindow(EarlyTerminationShare, this->windowScale) * this->tolerance
    : withoutTolerance;
}

double ErrorBudget::StepTolerance() const
{
  return this->isSampled ? this->stepFactor * this->tolerance : 0.0;
}

double ErrorBudget::LightOfLimit() const
{
  const double share = this->isOccluded ? OccludedStepShare : StepShare;
  return (1.0 - EarlyTerminationShare - share) / share;
}

ErrorLimit ErrorBudget::StepLimit() const
{
  const double tolerance =
    this->isExtreme ? ExtremesShare * this->StepTolerance() : this->StepTolerance();
  const double share = this->isOccluded ? OccludedStepShare : StepShare;
  return { share * tolerance, LargestStepShare * tolerance };
}

ErrorBudget ErrorBudget::WithStepFactor(double factor) const
{
  ErrorBudget budget = *this;
  budget.stepFactor *= factor;
  return budget;
}

}
