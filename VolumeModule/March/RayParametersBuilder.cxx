#include "March/RayParametersBuilder.h"

#include "Core/Geometry/PixelRays.h"
#include "Core/Geometry/ProjectedBox.h"
#include "Frame/FrameMeasures.h"
#include "March/Device/GraphicsDriver.h"
#include "March/SkyParameters.h"
#include "Resources/BlueNoiseTexture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// All blocks have the same rays, bit for bit, so no ray has a gap where two blocks meet.
void SetRays(RayParameters& p, const VolumeMarch& march, const Box& boxGrid)
{
  const glm::dmat4 clipFromGrid = march.frame.ClipFromGrid();
  const PixelRays rays = ComputePixelRays(clipFromGrid, boxGrid);
  for (int i = 0; i < 3; ++i)
  {
    p.rayStartGrid[i] = rays.startGrid[i];
    p.rayDirectionGrid[i] = rays.directionGrid[i];
  }
  p.nearPlaneGrid = rays.nearPlaneGrid;
  p.farPlaneGrid = rays.farPlaneGrid;
  p.boxLowerGrid = boxGrid.lower;
  p.boxUpperGrid = boxGrid.upper;
  p.clipFromGrid = clipFromGrid;
  p.clipDepthRow = glm::row(clipFromGrid, 2);
  p.clipWeightRow = glm::row(clipFromGrid, 3);
}

// The box of the volume of which the frame draws a part, or that of the frame.
Box WholeBoxGrid(const VolumeMarch& march)
{
  const Frame& frame = march.frame;
  return march.plan.wholeData ? BoxInGrid(frame, *march.plan.wholeData) : frame.cuts.boxGrid;
}

// A ray of a part numbers its segments like one of the whole.
int MostSegmentsOf(const VolumeMarch& march)
{
  const double step = march.plan.sampleDistanceMm;
  const int most = MostSegments(march.frame, step);
  if (!march.plan.wholeData)
  {
    return most;
  }
  return most + int(std::ceil(DiagonalMm(march.frame, WholeBoxGrid(march)) / step));
}

// The whole box has no part that is taken away because it is invisible, so that steps count from
// the same place for any transfer function.
void SetSpan(RayParameters& p, const VolumeMarch& march)
{
  const Frame& frame = march.frame;
  constexpr double Unlimited = 1e30;
  const bool countsFromHit = march.settings.integration == Integration::FirstHit;
  const double steps = frame.span.mostSteps > 0 ? double(frame.span.mostSteps) : Unlimited;
  p.firstDistanceMm = float(frame.span.firstDistanceMm);
  p.spanMm =
    float(countsFromHit ? Unlimited : std::min(steps * frame.quality.sampleDistanceMm, Unlimited));
  p.samplesAfterHit = float(steps);
  const Box wholeGrid = WholeBoxGrid(march);
  p.wholeLowerGrid = wholeGrid.lower;
  p.wholeUpperGrid = wholeGrid.upper;
  p.eyeGrid =
    glm::dvec3(glm::inverse(frame.geometry.worldFromGrid) * glm::dvec4(frame.view.eyeWorld, 1.0));
}

void SetCuts(RayParameters& p, const Cuts& cuts)
{
  p.clippingPlaneCount = int(cuts.planesGrid.size());
  if (cuts.regions)
  {
    std::copy(cuts.regions->planesGrid.begin(), cuts.regions->planesGrid.end(), p.croppingPlanes);
    p.croppingRegions = cuts.regions->drawn;
  }
}

void SetResampling(RayParameters& p, const VolumeMarch& march)
{
  const Viewport rays = RaysOf(march.plan.viewport, march.plan.imageSampleDistance);
  p.raysPerSide = rays.width / march.plan.viewport.width;
  p.lastCoarsePixel = glm::ivec2(rays.width, rays.height) - 1;
  p.coarsePerPixel = glm::dvec2(rays.width, rays.height) /
    glm::dvec2(march.plan.viewport.width, march.plan.viewport.height);
  p.sameSurfaceMm = float(march.frame.geometry.SmallestSpacingMm());
}

void SetPass(RayParameters& p, const VolumeMarch& march)
{
  p.leastOpacity = Picks(march.settings.pass) ? LeastPickedOpacity : LeastDepthOpacity;
  p.clampDepth = int(march.frame.image.clampDepth);
  const float* color = march.frame.pass.propColor;
  p.propColor = glm::dvec3(color[0], color[1], color[2]);
  // A voxel is a point, or a cell whose centre lies half a voxel beyond its first point.
  const int cells = march.frame.pass.picksCells ? 1 : 0;
  const int voxelsAreCells = march.frame.voxels.blanking.place == VoxelPlace::Cells ? 1 : 0;
  const glm::ivec3 count = march.frame.geometry.dimensions + voxelsAreCells - cells;
  p.pickedCount = glm::dvec3(glm::max(count, 1));
  p.pickedOffset = 0.5f * float(1 + voxelsAreCells - cells);
  p.pickedHighestBits = int(march.frame.pass.highestBits);
}

double WantedShadowStepMm(const VolumeMarch& march)
{
  return march.plan.LightStepMm(SmallestSpacingMm(march.frame));
}

bool IsEndedByRasterizer(const VolumeMarch& march)
{
  return IsInWayOfLights(march.settings) && march.plan.marcher == Marcher::Device &&
    IsSoftwareRasterizer();
}

// A segment takes up to two iterations, one to skip invisible bricks.
double ShortestShadowStepMm(const VolumeMarch& march)
{
  if (!IsEndedByRasterizer(march))
  {
    return 0.0;
  }
  constexpr double IterationsPerSegment = 2.0;
  const double rays = RaysToLights(march.frame.lights.lamps);
  return LongestRayMm(march.frame) *
    std::sqrt(IterationsPerSegment * rays / MostIterationsOfLight(march.settings));
}

}

Viewport RaysOf(const Viewport& frame, double imageSampleDistance)
{
  if (imageSampleDistance < 1.0)
  {
    const int perSide = int(std::lround(1.0 / imageSampleDistance));
    return { 0, 0, frame.width * perSide, frame.height * perSide };
  }
  const auto side = [&](int pixels)
  { return std::max(int(std::lround(pixels / imageSampleDistance)), 1); };
  return { 0, 0, side(frame.width), side(frame.height) };
}

bool HasLongShadowSteps(const VolumeMarch& march)
{
  // How many iterations it takes to find triangles depends on the geometry.
  const bool mayEnd = march.settings.casters && IsEndedByRasterizer(march);
  return mayEnd || WantedShadowStepMm(march) < ShortestShadowStepMm(march);
}

RayParameters RayParametersOf(const VolumeMarch& march, const Box& boxGrid)
{
  const Viewport& viewport = march.plan.viewport;
  RayParameters p = {};
  SetRays(p, march, boxGrid);
  p.viewportOriginPixels = glm::dvec2(viewport.left, viewport.bottom) - march.plan.rayOffsetPixels;
  p.viewportPixelsInverse = 1.0 / glm::dvec2(march.plan.ImagePixels());
  p.stepMm = float(march.plan.sampleDistanceMm);
  p.shadowStepMm = float(std::max(WantedShadowStepMm(march), ShortestShadowStepMm(march)));
  p.mostSegments = MostSegmentsOf(march);
  p.earlyTerminationTransmittance = float(march.frame.quality.earlyTerminationTransmittance);
  p.noisePixelsMask = glm::ivec2(BlueNoiseTexture::Pixels - 1);
  p.windowScaleBias = march.frame.image.windowScaleBias;
  SetSpan(p, march);
  SetCuts(p, march.frame.cuts);
  SetResampling(p, march);
  SetPass(p, march);
  return p;
}

}
