#ifndef Varimarch_Frame_MarchPlan_h
#define Varimarch_Frame_MarchPlan_h

#include "Core/Quality/InteractiveQuality.h"
#include "Frame/Frame.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace varimarch
{

/// Properties of a volume that are known once its resources are updated.
struct VolumeFindings
{
  bool skipsBricks = true; ///< True if rays can skip enough bricks for the field to pay.
  bool hasGaps = false;    ///< True if some cells have no value.
};

/// Decisions about a frame that are made after it is built. The frame itself does not change.
struct MarchPlan
{
  Marcher marcher = Marcher::Device;
  Integration integration = Integration::Midpoint;
  bool filters8Bits = false;        ///< True if texels of 8 bits may replace wider ones.
  Filter filter = Filter::OfDevice; ///< The way to values between texels.
  bool choosesIntegration = false;  ///< True if a trial may still change the integration rule.
  bool triesPreIntegration = false; ///< True if memory suffices for a pre-integrated table.
  ErrorBudget budget;
  double sampleDistanceMm = 0.0;
  double imageSampleDistance = 1.0; ///< The distance between rays [pixels].
  int mostAccumulated = 0;          ///< The number of images in the mean; 0: no accumulation.
  bool isInteractive = false;       ///< True while a user interacts.
  /// The box of the whole volume in the coordinates of the data, if a part of it takes its samples.
  std::optional<Box> wholeData;
  std::vector<VolumeFindings> volumes; ///< One entry for the first volume and each of the others.
  std::vector<VolumeFindings> coarser; ///< One entry for each coarser level.

  // One drawing of the image, or of a part of it.
  RayPass pass = RayPass::Whole;
  ShaderRole role = ShaderRole::MarchRays;
  Viewport viewport = {};
  glm::dvec2 rayOffsetPixels = glm::dvec2(0.0); ///< The offset of rays from their pixels' centres.
  bool addsUp = false;        ///< True if the colours are added to those in the framebuffer.
  bool isTrial = false;       ///< True for a trial image, in which fetches are not counted.
  bool isLit = true;          ///< False for a trial of opacities, which do not depend on light.
  bool hasSmallTable = false; ///< True for a trial with half of the pre-integrated values.

  /// The plan of another drawing of the same image.
  MarchPlan WithPass(RayPass otherPass) const;
  MarchPlan WithRole(ShaderRole otherRole) const;
  MarchPlan WithViewport(const Viewport& otherViewport) const;
};

/// The rays of a trial image for a frame of this size: enough to estimate the 99.9th percentile of
/// an error, in two tiles of a software rasteriser, so that two cores share the work.
Viewport TrialPixels(const Viewport& frame);

/// The initial plan of a frame, before the resources of its volumes are known.
/// @param quality  the quality of the image while a user interacts; none for a still image
MarchPlan PlanOf(const Frame& frame, const std::optional<PictureQuality>& quality);

/// The march of one volume of a frame.
struct VolumeMarch
{
  const Frame& frame; ///< The frame of the volume, possibly one of another frame's `others`.
  MarchPlan plan;
  RenderSettings settings; ///< The complete recipe, from the frame and the plan.
};

/// The march of the first volume. Its settings contain those of the others.
VolumeMarch MarchOf(const Frame& frame, const MarchPlan& plan);

/// The march of a volume that overlaps with the first.
VolumeMarch MarchOfOther(const Frame& frame, const MarchPlan& plan, std::size_t other);

/// The march of a coarser level.
VolumeMarch MarchOfCoarser(const Frame& frame, const MarchPlan& plan, std::size_t level);

}

#endif
