#ifndef Varimarch_Core_Quality_StepSearch_h
#define Varimarch_Core_Quality_StepSearch_h

#include <functional>
#include <vector>

namespace varimarch
{

/// What a picture may be off by in a premultiplied channel, of 1: 99.9 of 100 pixels by
/// `percentile999`, and none by more than `largest`.
struct ErrorLimit
{
  double percentile999;
  double largest;
};

struct StepChoice
{
  double sampleDistance;
  double error;   ///< estimate of the 99.9th percentile, of 1
  double ofLimit; ///< at most 1; above only where the finest distance does not keep the limit

  bool KeepsLimit() const { return this->ofLimit <= 1.0; }
};

/// What a search ends with.
struct FoundSteps
{
  StepChoice choice;
  std::vector<float> finest; ///< picture that others were compared with, its error a small part of
                             ///< the limit if the choice keeps that
};

/// Whether the steps of one rule are better than another's: so much longer that what one costs is
/// made up for, or, where the other's do not keep the limit, nearer to it.
/// @param cost  of a step, in those of the other rule
bool IsBetter(const StepChoice& choice, double cost, const StepChoice& other);

/// Where to search. Half of the finest is drawn too.
struct StepRange
{
  double coarsest;
  double finest; ///< at most the coarsest
};

/// Draws a sample of a picture's pixels at a sample distance: premultiplied RGBA, always the same
/// pixels.
using SampleDrawing = std::function<std::vector<float>(double sampleDistance)>;

/// Finds about the largest sample distance at which a picture keeps its limit. The error at a
/// distance is estimated by what about a quarter of it changes: for a rule of order p that is
/// 1 - 4^-p of the error (Richardson 1911), and nearly all of it where noise makes errors that do
/// not depend on each other, of which halving would change more than there is. From an error to
/// the next distance the error is taken as a power of it.
/// @param first  the distance to begin with; the nearer to the result, the fewer drawings. Where
///               the error does not grow with the distance, the result depends on it.
/// @param exact  nearly the picture without an error, where one is known: the same pixels
FoundSteps FindSampleDistance(const SampleDrawing& draw, const ErrorLimit& limit,
  const StepRange& range, double first, const std::vector<float>& exact = {});

/// How far one picture is from another as a part of what the limit allows.
double DifferenceOfLimit(
  const std::vector<float>& a, const std::vector<float>& b, const ErrorLimit& limit);

/// The same, where the largest difference counts too: of a picture beside one without an error.
double ErrorOfLimit(
  const std::vector<float>& picture, const std::vector<float>& exact, const ErrorLimit& limit);

}

#endif
