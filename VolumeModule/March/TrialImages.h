#ifndef Varimarch_March_TrialImages_h
#define Varimarch_March_TrialImages_h

#include "Frame/MarchPlan.h"
#include "March/SearchFacts.h"

#include <deque>
#include <functional>
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

}

#endif
