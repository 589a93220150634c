#include "March/TrialImages.h"

#include "Core/Quality/TrialDistances.h"
#include "March/RayParametersBuilder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

bool IsSame(const TrialImage& one, const TrialImage& other)
{
  constexpr double Same = 1e-6;
  return one.integration == other.integration && one.isLit == other.isLit &&
    one.hasSmallTable == other.hasSmallTable && one.isSmall == other.isSmall &&
    one.light == other.light &&
    std::abs(one.sampleDistanceMm / other.sampleDistanceMm - 1.0) < Same;
}

}

MarchPlan TrialImage::PlanOf(const MarchPlan& image) const
{
  const Viewport all = RaysOf(image.viewport, image.imageSampleDistance);
  constexpr int RaysIfSmall = 48 * 24;
  MarchPlan tried =
    image.WithViewport(this->isSmall ? TrialPixels(all, RaysIfSmall) : TrialPixels(all));
  tried.pass = RayPass::Whole;
  tried.integration = this->integration;
  tried.sampleDistanceMm = this->sampleDistanceMm;
  tried.isTrial = true;
  tried.triedPixels = { all.width, all.height };
  tried.isLit = this->isLit;
  tried.hasSmallTable = this->hasSmallTable;
  tried.light = this->light;
  return tried;
}

const std::vector<float>& TrialImages::Of(const TrialImage& image)
{
  if (!this->Find(image))
  {
    const std::vector<TrialImage> images = this->AllWith(image);
    std::vector<std::vector<float>> all = this->draw(images);
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      this->drawn.push_back({ images[i], std::move(all[i]) });
    }
  }
  return this->Find(image)->rgba;
}

const TrialImages::Drawn* TrialImages::Find(const TrialImage& image) const
{
  const auto found = std::find_if(this->drawn.begin(), this->drawn.end(),
    [&](const Drawn& one) { return IsSame(one.image, image); });
  return found == this->drawn.end() ? nullptr : &*found;
}

// There is one table at a time, for one distance.
bool TrialImages::IsByTable(const TrialImage& image) const
{
  return image.integration == Integration::PreIntegrated &&
    (this->preIntegratesByTable || !image.isLit);
}

std::vector<TrialImage> TrialImages::AllWith(const TrialImage& image) const
{
  std::vector<TrialImage> images = { image };
  const bool isOneOfAKind = image.light.sampleDistanceMm > 0.0;
  if (!this->range.isOfHalfOctaves || this->IsByTable(image) || isOneOfAKind)
  {
    return images;
  }
  for (const double distanceMm : DistancesDrawnWith(image.sampleDistanceMm, this->range))
  {
    TrialImage other = image;
    other.sampleDistanceMm = distanceMm;
    const bool isAmong = std::any_of(
      images.begin(), images.end(), [&](const TrialImage& one) { return IsSame(one, other); });
    if (!isAmong && !this->Find(other))
    {
      images.push_back(other);
    }
  }
  return images;
}

}
