#include "March/SkyParameters.h"

#include "Core/Geometry/SphereQuadrature.h"
#include "Frame/FrameMeasures.h"
#include "March/Processor/SoftwareRasterizer.h"

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
  const double reachMm =
    std::min(march.frame.material.occlusionReachMm, march.frame.geometry.DiagonalMm());
  const double ofRay = march.settings.nearest
    ? MostBoxesPerVoxel / BoxesPerIteration * reachMm / march.frame.geometry.SmallestSpacingMm()
    : (reachMm / double(sky.stepMm) + MoreSegments) / SegmentsPerIteration;
  const double ofPlanes = 1.0 + double(march.frame.cuts.planesGrid.size());
  return SphereDirections * (1.0 + ofPlanes + std::ceil(ofRay));
}

// The largest number of places that a ray may have.
double PlacesOfRay(const VolumeMarch& march)
{
  const glm::ivec3& voxels = march.frame.geometry.dimensions;
  return march.settings.nearest ? double(voxels.x + voxels.y + voxels.z)
                                : march.frame.geometry.DiagonalMm() / SkyPlacesMm(march);
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
  const bool hasPieces =
    settings.nearest || settings.cropping || settings.gaps || settings.mask != Mask::None;
  return hasPieces ? OfPieces : Usual;
}

// The rays to all sides have the iterations that the segments of the rays of the eye leave.
int MostSkyPlaces(const VolumeMarch& march, const PacketSky& sky)
{
  if (!EndsLongShaders(march.plan.marcher))
  {
    return std::numeric_limits<int>::max();
  }
  constexpr double IterationsOfSegment = 6.0;
  const double segments = march.frame.geometry.DiagonalMm() / march.plan.sampleDistanceMm;
  const double left = MostIterationsOfLight(march.settings) - IterationsOfSegment * segments;
  return std::max(int(left / (TracesOfPlace(march.settings) * IterationsOfPlace(march, sky))), 1);
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
  const bool isShared = frame.settings.occlusion && EndsLongShaders(marcher);
  return (isShared ? 4.0 : 1.0) * ShortestSampleDistanceMm(frame, marcher);
}

double MostIterationsOfLight(const RenderSettings& settings)
{
  return MostShaderIterations * (settings.shadows && settings.occlusion ? 0.5 : 1.0);
}

}
