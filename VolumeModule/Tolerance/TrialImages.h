#ifndef Varimarch_Tolerance_TrialImages_h
#define Varimarch_Tolerance_TrialImages_h

#include "Core/Quality/MarchWork.h"
#include "Frame/MarchPlan.h"
#include "Tolerance/SearchFacts.h"

#include <deque>
#include <exception>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace varimarch
{

/// A trial image of a search.
struct TrialImage
{
  Integration integration;
  double sampleDistanceMm;
  bool isLit;         ///< False for opacities alone, which do not depend on light.
  bool hasSmallTable; ///< True for half of the pre-integrated values.
  bool isSmall;       ///< True for a quarter of the rays.
  LightSource light;

  /// The plan that draws it.
  MarchPlan PlanOf(const MarchPlan& image) const;
};

/// Draws trial images that differ in their sample distances only. It returns premultiplied RGBA of
/// the pixels of each.
using TrialDrawing =
  std::function<std::vector<std::vector<float>>(const std::vector<TrialImage>& images)>;

/// The trial images of one search, each of which is drawn once. In a search of half octaves an
/// image is drawn together with those that may be asked for next: such a search is for voxels that
/// do not fit in memory, so that each pass over the rays reads them anew.
class TrialImages
{
public:
  /// @param draw  outlives the images
  TrialImages(const SearchFacts& facts, const TrialDrawing& draw)
    : range(facts.range)
    , preIntegratesByTable(facts.preIntegratesByTable)
    , draw(draw)
  {
  }

  /// Premultiplied RGBA of the pixels of an image.
  const std::vector<float>& Of(const TrialImage& image);

private:
  struct Drawn
  {
    TrialImage image;
    std::vector<float> rgba;
  };

  const Drawn* Find(const TrialImage& image) const;
  /// An image and those that are drawn with it.
  std::vector<TrialImage> AllWith(const TrialImage& image) const;

  bool IsByTable(const TrialImage& image) const;

  StepRange range;
  bool preIntegratesByTable;
  const TrialDrawing& draw;
  std::deque<Drawn> drawn;
};

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
