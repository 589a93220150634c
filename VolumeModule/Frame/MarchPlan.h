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

/// Properties of a volume that its resources have found.
struct VolumeFindings
{
  bool skipsBricks = true; ///< True if the field has enough bricks that rays can cross in one step.
  bool hasGaps = false;    ///< True if cells are left out.
};

/// Decisions about a frame that are made after it is built. The frame itself stays as it was asked
/// for.
struct MarchPlan
{
  Marcher marcher = Marcher::Device;
  Integration integration = Integration::Midpoint;
  bool choosesIntegration = false;  ///< True if a trial may still change the integration rule.
  bool triesPreIntegration = false; ///< True if there is memory for a pre-integrated table.
  ErrorBudget budget;
  double sampleDistanceMm = 0.0;
  double imageSampleDistance = 1.0;    ///< The distance of rays [pixels].
  int mostAccumulated = 0;             ///< The images that are accumulated at most; 0: none is.
  std::vector<VolumeFindings> volumes; ///< One for the first volume and for each of the others.

  // One drawing of the image, or of a part of it.
  RayPass pass = RayPass::Whole;
  ShaderRole role = ShaderRole::MarchRays;
  Viewport viewport = {};
  glm::dvec2 rayOffsetPixels = glm::dvec2(0.0); ///< The place of a ray from its pixel's middle.
  bool addsUp = false;  ///< True if the colours are added to what the framebuffer holds.
  bool isTrial = false; ///< True while steps are tried out, for which fetches are not counted.
  bool isLit = true;    ///< False while opacities are tried out, which do not depend on light.

  /// The plan of another drawing of the same image.
  MarchPlan WithPass(RayPass otherPass) const;
  MarchPlan WithRole(ShaderRole otherRole) const;
  MarchPlan WithViewport(const Viewport& otherViewport) const;
};

/// The rays of a trial image for a frame of this size: enough to show the 99.9th percentile of an
/// error, in two tiles of a software rasteriser, so that two cores share the work.
Viewport TrialPixels(const Viewport& frame);

/// The plan that a frame begins with, before anything is known of its volumes.
/// @param quality  how coarse the image may be while a user interacts; none where nobody waits
MarchPlan PlanOf(const Frame& frame, const std::optional<PictureQuality>& quality);

/// One volume of a frame, as its plan has it marched.
struct VolumeMarch
{
  const Frame& frame; ///< The frame of the volume, which may be one of another's `others`.
  MarchPlan plan;
  RenderSettings settings; ///< The recipe: what the frame asks for and the plan decides.
};

/// The march of the first volume, whose settings have those of the others in them.
VolumeMarch MarchOf(const Frame& frame, const MarchPlan& plan);

/// The march of a volume that overlaps with the first.
VolumeMarch MarchOfOther(const Frame& frame, const MarchPlan& plan, std::size_t other);

}

#endif
