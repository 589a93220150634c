#ifndef Varimarch_Core_Quality_ErrorBudget_h
#define Varimarch_Core_Quality_ErrorBudget_h

#include "Core/Quality/StepSearch.h"

namespace varimarch
{

/// Divides the error tolerance of an image among all approximations of the march. The tolerance is
/// a promise about premultiplied colours and opacity, of 1, after window and level: 99.9 % of the
/// pixels are off by no more than that. It is divided into
///   - the field's part: homogeneous bricks that a ray crosses in one step;
///   - the part of early termination: what lies behind the point where a ray ends;
///   - the steps' part: sample distance and integration rule, which a search tries out.
struct ErrorBudget
{
  /// The part of the field.
  static constexpr double FieldShare = 1.0 / 8.0;
  /// The part of early termination.
  static constexpr double EarlyTerminationShare = 1.0 / 8.0;
  /// The part of the steps, as the 99.9th percentile of their errors. The rest is a reserve for the
  /// slack of the estimate.
  static constexpr double StepShare = 0.66;
  /// The largest error of the pixels that are tried out. They are few, so a stricter limit would
  /// only react to chance.
  static constexpr double LargestStepShare = 1.0;
  /// The part of the steps' part that maximum and minimum intensity may use. Their error is large
  /// on the few rays that find the second highest peak, and a trial meets fewer of those rays
  /// still.
  static constexpr double ExtremesShare = 0.4;
  /// The estimate of an error is itself off by this factor: a distance within it counts as kept.
  static constexpr double EstimateSlack = 1.15;
  /// The largest factor of the steps' part while a user interacts.
  static constexpr double MostWhileMoving = 4.0;
  /// The factor of the steps' part in the second and later images of an accumulation, whose mean
  /// shall be better than one image.
  static constexpr double LaterImages = 1.0 / 4.0;
  /// The factor of a sample distance that has no tolerance there: the rules are of second order, so
  /// half the distance makes a quarter of the error.
  static constexpr double LaterDistance = 1.0 / 2.0;
  /// The error that homogeneous bricks may add if no tolerance is asked for: one level of 8 bits.
  /// Extremes are then exact.
  static constexpr double FieldErrorWithoutTolerance = 1.0 / 255.0;

  double tolerance = 0.0;   ///< The promise; 0 where none is asked for.
  double windowScale = 1.0; ///< Window and level multiply colours, and their errors, by this.
  bool isExtreme = false;   ///< True for maximum and minimum intensity.
  bool isSampled = true;    ///< False where rays are not sampled, and steps make no error.
  int volumeCount = 1;      ///< Overlapping volumes share the field's part.
  double stepFactor = 1.0;  ///< The factor of the steps' part in this image.

  bool HasTolerance() const { return this->tolerance > 0.0; }

  /// The error that the homogeneous bricks of one volume may add to a component of a pixel.
  double FieldError() const;

  /// The transmittance at which a ray may end.
  /// @param withoutTolerance  the transmittance where no tolerance is asked for
  double EarlyTermination(double withoutTolerance) const;

  /// The tolerance of the steps alone; 0 where there is none to keep.
  double StepTolerance() const;

  /// The errors that a trial of the steps may show.
  ErrorLimit StepLimit() const;

  /// The budget of an image that allows its steps a larger or smaller error. The field's part stays
  /// as it is, because the field would have to be built again.
  ErrorBudget WithStepFactor(double factor) const;
};

}

#endif
