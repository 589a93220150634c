#include "March/SkyParameters.h"

#include "Core/Geometry/SphereQuadrature.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"
#include "March/Device/GraphicsDriver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

// The distance between the places of a ray from which rays go to all sides. Light changes little
// over a quarter of a voxel, so that shorter steps need no more places.
double SkyPlacesMm(const VolumeMarch& march)
{
  const double stepMm = march.plan.sampleDistanceMm;
  const double wantedMm = march.frame.geometry.SmallestSpacingMm() / 4.0;
  return std::max(std::round(wantedMm / stepMm), 1.0) * stepMm;
}

// The iterations of loops that the rays from one place take. The first segments are shorter, and
// boxes of voxels have their own.
double IterationsOfPlace(const VolumeMarch& march, const PacketSky& sky)
{
  constexpr double MoreSegments = 3.0;
  constexpr double MostBoxesPerVoxel = 1.75;
  constexpr double SegmentsPerIteration = 4.0;
  constexpr double BoxesPerIteration = 3.0;
  const MaterialRequest& material = march.frame.material;
  const double reachMm = std::min(material.occlusionReachMm, material.occludersMm);
  const double ofBoxes = MostBoxesPerVoxel / BoxesPerIteration * reachMm / material.occluderVoxelMm;
  const double ofSegments = (reachMm / double(sky.stepMm) + MoreSegments) / SegmentsPerIteration;
  const double ofRay = march.settings.overlaps ? std::max(ofBoxes, ofSegments)
    : march.settings.nearest                   ? ofBoxes
                                               : ofSegments;
  const double ofPlanes = 1.0 + double(march.frame.cuts.planesGrid.size());
  const double volumes = march.plan.budget.volumeCount;
  return SphereDirections * (1.0 + ofPlanes + volumes * std::ceil(ofRay));
}

// The largest number of places that a ray may have.
double PlacesOfRay(const VolumeMarch& march)
{
  const glm::ivec3& voxels = march.frame.geometry.dimensions;
  const double places = march.settings.nearest
    ? double(voxels.x + voxels.y + voxels.z)
    : march.frame.geometry.DiagonalMm() / SkyPlacesMm(march);
  return places * PartCount(march.settings);
}

bool EndsLongShaders(Marcher marcher)
{
  return marcher == Marcher::Device && IsSoftwareRasterizer();
}

// Pixels are drawn in vectors, all of which wait where one is traced. Mostly they are traced
// together, less often where each has pieces or boxes of its own.
double TracesOfPlace(const RenderSettings& settings)
{
  constexpr double Usual = 2.0;
  constexpr double OfPieces = 4.0;
  const bool hasPieces = settings.nearest || settings.cropping || settings.gaps ||
    settings.mask != Mask::None || settings.overlaps;
  return hasPieces ? OfPieces : Usual;
}

// The rays to all sides have the iterations that the segments of the rays of the eye leave, and
// volumes that overlap have equal parts of them.
int MostSkyPlaces(const VolumeMarch& march, const PacketSky& sky)
{
  if (!EndsLongShaders(march.plan.marcher))
  {
    return std::numeric_limits<int>::max();
  }
  const double volumes = march.plan.budget.volumeCount;
  const double iterationsOfSegment = std::max(6.0, 2.0 + 2.0 * volumes);
  const double segments = march.frame.material.occludersMm / march.plan.sampleDistanceMm;
  const double left = MostIterationsOfLight(march.settings) - iterationsOfSegment * segments;
  const double ofPlaces = TracesOfPlace(march.settings) * IterationsOfPlace(march, sky) * volumes;
  return std::max(int(left / ofPlaces), 1);
}

}

void SetSky(VolumeParameters& p, const VolumeMarch& march, const PacketSky& sky)
{
  if (march.settings.occlusion)
  {
    p.skyStrength = sky.strength;
    p.skyReachMm = sky.reachMm;
    p.skyStepMm = sky.stepMm;
    p.skyMostDepth = sky.mostDepth;
    p.skyPlacesMm = float(SkyPlacesMm(march));
    p.mostSkyPlaces = MostSkyPlaces(march, sky);
  }
}

bool HasFewSkyPlaces(const VolumeMarch& march, const PacketSky& sky)
{
  return march.settings.occlusion && MostSkyPlaces(march, sky) < PlacesOfRay(march);
}

double ShortestDistanceWithSkyMm(const Frame& frame, Marcher marcher)
{
  const bool isShared = IsInWayOfSky(frame.settings) && EndsLongShaders(marcher);
  return (isShared ? 4.0 : 1.0) * ShortestSampleDistanceMm(frame, marcher);
}

double MostIterationsOfLight(const RenderSettings& settings)
{
  return MostShaderIterations * (IsInWayOfLights(settings) && IsInWayOfSky(settings) ? 0.5 : 1.0);
}

}
