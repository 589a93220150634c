#ifndef Varimarch_Frame_MapperNumbers_h
#define Varimarch_Frame_MapperNumbers_h

#include <glm/vec3.hpp>

#include <array>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

class NumberCheck;

/// The settings of a mapper that are numbers, in its units, as far as they have a meaning. The
/// setters clamp numbers, but accept NaN.
struct MapperNumbers
{
  double errorTolerance;
  double variationTolerance;
  double sampleDistanceMm;
  double sampleDistanceInVoxels;
  double firstDistanceMm;
  double earlyTerminationTransmittance;
  double imageSampleDistance;
  std::array<double, 2> interactiveSampleDistances; ///< The shortest and the longest.
  double longestPartSeconds;
  double window; ///< The window of the colours of the image.
  double level;
  glm::dvec3 nanColor;
  double nanOpacity;
  double dampingGradient;
  double shadowStrength;
  double scatteringBlending;
  double illuminationReach;
  double scatteringAnisotropy;
  double occlusion;
  double occlusionReachMm;
  double maskBlendFactor;
  std::array<double, 2> averagedRange;
};

MapperNumbers MapperNumbersOf(vtkVariationFieldVolumeMapper* mapper, NumberCheck& check);

}

#endif
