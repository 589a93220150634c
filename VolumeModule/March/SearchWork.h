#ifndef Varimarch_March_SearchWork_h
#define Varimarch_March_SearchWork_h

#include "Core/Quality/MarchWork.h"
#include "March/ToleranceSearch.h"

#include <exception>
#include <limits>
#include <utility>
#include <vector>

namespace varimarch
{

/// The end of a search for steps whose trial images would take more work than a search may.
class WorkUsedUp : public std::exception
{
public:
  const char* what() const noexcept override { return "The search for steps took too much work"; }
};

/// The work of the trial images of one search. It is bounded if volumes dim light, whose rays make
/// the work grow without an end; a trial that is foreseen to exceed the bound is not begun.
class SearchWork
{
public:
  /// The time of processors that a search may take where light is dimmed [s].
  static constexpr double MostSeconds = 40.0;

  /// @param dimsLight  true if volumes dim the light
  /// @param isWanted   see MarchWork
  SearchWork(bool dimsLight, MarchWork::Question isWanted)
    : mostSeconds(dimsLight ? MostSeconds : std::numeric_limits<double>::infinity())
    , march(TimesUnforeseen * this->mostSeconds, std::move(isWanted))
  {
  }

  /// @throws WorkUsedUp if a trial image may exceed the bound
  void Begin(const TrialImage& image);
  /// @throws WorkUsedUp if the trial image was cut short
  void End(const TrialImage& image, const std::vector<float>& rgba);

  /// The steps of a search that has used up its work: those of the finest trial image, whose error
  /// is at most about its difference from a coarser one. They do not keep the limit.
  ToleranceChoice Unfinished(const SearchFacts& facts) const;

  MarchWork& March() { return this->march; }

private:
  static constexpr double TimesUnforeseen = 2.0;

  /// A trial image with light.
  struct Tried
  {
    TrialImage image;
    std::vector<float> rgba;
    double seconds;
  };

  double mostSeconds;
  MarchWork march;
  double beforeSeconds = 0.0; ///< The work before the present trial image.
  std::vector<Tried> tried;   ///< The coarsest first.
};

}

#endif
