#ifndef Varimarch_Frame_MarchPlan_h
#define Varimarch_Frame_MarchPlan_h

#include "Core/Geometry/Box.h"
#include "Core/Quality/InteractiveQuality.h"
#include "Core/Quality/StepSearch.h"
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

class MarchWork;

/// The way to the light that shadows and ambient occlusion leave at a place.
struct LightSource
{
  /// The largest difference between the nodes of a cell in which light is interpolated, as a
  /// fraction of the largest that LightResources allows, [0, 1]; 0 if all light is traced.
  double latticePart = 1.0;
  /// The sample distance that the steps of rays to lights and of ambient occlusion follow [mm]; 0
  /// for that of the image.
  double sampleDistanceMm = 0.0;

  bool IsTraced() const { return !(this->latticePart > 0.0); }

  bool operator==(const LightSource& other) const
  {
    return this->latticePart == other.latticePart &&
      this->sampleDistanceMm == other.sampleDistanceMm;
  }
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

  MarchWork* work = nullptr; ///< Counts the work of the march, and may end it; null: no count.

  // One drawing of the image, or of a part of it.
  RayPass pass = RayPass::Whole;
  ShaderRole role = ShaderRole::MarchRays;
  Viewport viewport = {};
  glm::dvec2 rayOffsetPixels = glm::dvec2(0.0); ///< The offset of rays from their pixels' centres.
  glm::ivec2 triedPixels = glm::ivec2(0); ///< The size of the image that a trial image has rays of.
  bool addsUp = false;        ///< True if the colours are added to those in the framebuffer.
  bool isTrial = false;       ///< True for a trial image, in which fetches are not counted.
  bool isLit = true;          ///< False for a trial of opacities, which do not depend on light.
  LightSource light;          ///< The way to the light that shadows and ambient occlusion leave.
  bool hasSmallTable = false; ///< True for a trial with half of the pre-integrated values.

  /// The longest segment of rays to lights, and the distance between places along a ray of the eye
  /// at which light is found. Below the spacing of the voxels it is the geometric mean of that and
  /// the sample distance, because light changes less than what is seen, and the time of shadows is
  /// inverse to its square.
  double LightStepMm(double spacingMm) const;
  /// The longest segment of rays to all sides. A mean over all sides changes even less, so that
  /// below the spacing of the voxels it falls with the cube root of the sample distance.
  double OcclusionStepMm(double spacingMm) const;

  /// The plan of another drawing of the same image.
  MarchPlan WithPass(RayPass otherPass) const;
  MarchPlan WithRole(ShaderRole otherRole) const;
  MarchPlan WithViewport(const Viewport& otherViewport) const;
  /// The size of the image whose rays are marched, of which a trial image has a part.
  glm::ivec2 ImagePixels() const;
};

/// The rays of a trial image for an image of this size: all of a small one, otherwise enough to
/// estimate the 99.9th percentile of an error, in two tiles of a software rasteriser, so that two
/// cores share the work. Shaders/Math/TrialPixel.glsl says which rays they are.
/// @param most  the number of rays; a quarter of the usual number for a small trial image
Viewport TrialPixels(const Viewport& image, int most = 96 * 48);

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

/// Steps that several mappers share, each of which draws a part of a volume.
struct CommonSteps
{
  StepChoice step;      ///< [mm]
  bool isPreIntegrated; ///< True for pre-integration, false for midpoints, if a trial may choose.
  LightSource light;    ///< The way to the light of the images.
  Box wholeData;        ///< The box around all parts, in the coordinates of the data.
};

}

#endif
