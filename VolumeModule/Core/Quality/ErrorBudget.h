#ifndef Varimarch_Core_Quality_ErrorBudget_h
#define Varimarch_Core_Quality_ErrorBudget_h

#include "Core/Quality/StepSearch.h"

namespace varimarch
{

/// Divides the error tolerance of an image among all approximations of the march. The tolerance is
/// a promise about premultiplied colours and opacity in [0, 1], after window and level: the error
/// of 99.9 % of the pixels is at most the tolerance. It is divided among
///   - the field: homogeneous bricks that a ray crosses in one step; in images with shadows, which
///     have no such bricks, the light;
///   - early termination: the part of a ray behind the point where it ends;
///   - the steps: sample distance and integration rule, which a search tries out.
struct ErrorBudget
{
  /// The part of the field.
  static constexpr double FieldShare = 1.0 / 8.0;
  /// The part of early termination.
  static constexpr double EarlyTerminationShare = 1.0 / 8.0;
  /// The part of the steps, as the 99.9th percentile of their errors. The rest is a reserve for the
  /// slack of the estimate.
  static constexpr double StepShare = 0.66;
  /// The same in images with ambient occlusion. Between the nodes of its lattice light errs by up
  /// to a hundredth, a quarter of a tolerance of 1/64, which the reserve and this leave.
  static constexpr double OccludedStepShare = 0.45;
  /// The limit for the largest error of a trial's pixels. They are few, so a stricter limit would
  /// only react to chance.
  static constexpr double LargestStepShare = 1.0;
  /// The part of the steps' part that maximum and minimum intensity may use. Their error is large
  /// on the few rays that find only the second highest peak, and a trial has even fewer of those
  /// rays.
  static constexpr double ExtremesShare = 0.4;
  /// The inaccuracy of an estimated error: an excess by at most this factor counts as kept.
  static constexpr double EstimateSlack = 1.15;
  /// The largest factor of the steps' part while a user interacts.
  static constexpr double MostWhileMoving = 4.0;
  /// The factor of the steps' part in the second and later images of an accumulation, whose mean
  /// should be more exact than one image.
  static constexpr double LaterImages = 1.0 / 4.0;
  /// The factor of the sample distance in later images without a tolerance: the rules are of second
  /// order, so half the distance makes a quarter of the error.
  static constexpr double LaterDistance = 1.0 / 2.0;
  /// The error that homogeneous bricks may add without a tolerance: one level of 8 bits. Extremes
  /// are then exact.
  static constexpr double FieldErrorWithoutTolerance = 1.0 / 255.0;

  double tolerance = 0.0;   ///< The error tolerance; 0 if there is none.
  double windowScale = 1.0; ///< The factor of colours, and their errors, by window and level.
  bool isExtreme = false;   ///< True for maximum and minimum intensity.
  bool isSampled = true;    ///< False if steps make no error, because rays are not sampled.
  int volumeCount = 1;      ///< The number of overlapping volumes, which share the field's part.
  double stepFactor = 1.0;  ///< The factor of the steps' part in this image.
  bool isOccluded = false;  ///< True with ambient occlusion.

  bool HasTolerance() const { return this->tolerance > 0.0; }

  /// The error that the homogeneous bricks of one volume may add to a component of a pixel.
  double FieldError() const;

  /// The error that shadows may add to a component of a pixel, besides that of their steps.
  double LightError() const;

  /// The error that light which is interpolated may add, in parts of the limit of the steps: all
  /// that these and early termination leave.
  double LightOfLimit() const;

  /// The transmittance at which a ray may end.
  /// @param withoutTolerance  the result if there is no tolerance
  double EarlyTermination(double withoutTolerance) const;

  /// The tolerance of the steps alone; 0 if there is none.
  double StepTolerance() const;

  /// The errors that a trial of the steps may show.
  ErrorLimit StepLimit() const;

  /// The budget of an image that allows its steps a larger or smaller error. The field's part does
  /// not change, because the field would have to be rebuilt.
  ErrorBudget WithStepFactor(double factor) const;
};

}

#endif
