#ifndef Varimarch_Core_Quality_StepSearch_h
#define Varimarch_Core_Quality_StepSearch_h

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace varimarch
{

/// Accepted errors of a premultiplied channel, which is in [0, 1]: 99.9 % of the pixels are within
/// `percentile999`, and all are within `largest`.
struct ErrorLimit
{
  double percentile999;
  double largest;
};

struct StepChoice
{
  double sampleDistance;
  double error;   ///< estimated 99.9th percentile of the channel errors, in [0, 1]
  double ofLimit; ///< error / limit; above 1 only if no distance that was tried keeps the limit
  bool isOfBoundedWork = false; ///< true if finer distances were left out, as they take too long

  bool KeepsLimit() const { return this->ofLimit <= 1.0; }
};

/// The result of a search.
struct FoundSteps
{
  StepChoice choice;
  /// The image that others were compared with; its error is a small part of a kept limit.
  std::vector<float> finest;
};

/// True if the steps of one rule are better than those of another: if they are longer by more than
/// their cost or, if the other steps do not keep the limit, if they come closer to it.
/// @param cost  cost of one step, relative to a step of the other rule
bool IsBetter(const StepChoice& choice, double cost, const StepChoice& other);

/// The order by which errors usually fall with the sample distance: the rules are of second order,
/// but trilinear data has kinks at cell faces.
constexpr double UsualOrder = 1.6;

/// Distances to search. Half of the finest is drawn too.
struct StepRange
{
  double coarsest;
  double finest; ///< at most the coarsest
  /// True if only halves of octaves from the first distance are drawn, of which the longest that
  /// keeps the limit is taken.
  bool isOfHalfOctaves = false;
  /// The order by which errors are supposed to fall until two distances tell it, from 1 on.
  double supposedOrder = UsualOrder;
};

/// Draws some pixels of an image, always the same ones, at a sample distance; returns premultiplied
/// RGBA.
using SampleDrawing = std::function<std::vector<float>(double sampleDistance)>;

/// Finds approximately the largest sample distance at which an image keeps its limit.
///
/// The error at a distance is estimated from the change when the distance is divided by about four.
/// For a rule of order p this change is 1 - 4^-p of the error (Richardson 1911). If errors are
/// independent noise, the change is still close to the error, whereas halving the distance would
/// change the image by more than its error. The next distance follows from a power law for the
/// error.
/// @param first  distance to begin with; the closer to the result, the fewer drawings. If the error
/// does not grow with the distance, the result depends on it.
/// @param exact  the same pixels almost without error, if known
FoundSteps FindSampleDistance(const SampleDrawing& draw, const ErrorLimit& limit,
  const StepRange& range, double first, const std::vector<float>& exact = {});

/// The same, beginning at the distance of a search for a similar image. It needs two drawings if
/// the error there is near the limit even if it should fall as slowly as at opaque surfaces. No
/// image is compared with a coarser one than in a search from `first`, so that a feature which that
/// search sees is not missed.
FoundSteps FindSampleDistanceFrom(double earlier, const SampleDrawing& draw,
  const ErrorLimit& limit, const StepRange& range, double first);

/// The first of some distances that keeps the limit; the last, if none does. It needs a drawing for
/// each that is tried, and one more to compare them with.
/// @param distances  at least one, descending
/// @param first  that of a search: no distance is compared with a coarser one than a quarter of it
StepChoice FirstThatKeeps(const std::vector<double>& distances, const SampleDrawing& draw,
  const ErrorLimit& limit, const StepRange& range, double first);

/// Difference between two images, as a fraction of the limit for the 99.9th percentile.
double DifferenceOfLimit(
  const std::vector<float>& a, const std::vector<float>& b, const ErrorLimit& limit);

/// Error of an image compared with an exact one, as a fraction of the limit; the largest difference
/// counts too.
double ErrorOfLimit(
  const std::vector<float>& picture, const std::vector<float>& exact, const ErrorLimit& limit);

/// A sample distance, first, and those that a search of half octaves may draw next. Each image is
/// compared with one at a quarter of its distance, and shorter distances take most of the time.
inline std::vector<double> DistancesDrawnWith(double distance, const StepRange& range)
{
  constexpr int HalvesLonger = 4;
  constexpr int HalvesShorter = 8;
  std::vector<double> distances = { distance };
  for (int halves = -HalvesShorter; halves <= HalvesLonger; ++halves)
  {
    distances.push_back(
      std::clamp(distance * std::exp2(0.5 * halves), 0.5 * range.finest, range.coarsest));
  }
  return distances;
}

}

#endif
