#ifndef Varimarch_Core_Packets_Volumes_MixedSegment_h
#define Varimarch_Core_Packets_Volumes_MixedSegment_h

// A segment of a march through a mixture, to which its constituents add themselves.

#include "Core/Packets/Volumes/MixedLight.h"

namespace varimarch
{

namespace
{

/// A part of a segment.
struct MixedPart
{
  Optical& sum;     ///< emission (as the color) [1/mm] and extinction
  Lanes3* byLights; ///< emission that shadows may take away; null: there are none
  int lightCount;   ///< number of these lights
};

struct MixedSegment
{
  Optical parts[PartsPerSegment] = {};
  EmissionByLights* byLights = nullptr;
  int lightCount = 0;

  MixedPart Part(int part)
  {
    return { this->parts[part], this->byLights ? (*this->byLights)[part] : nullptr,
      this->lightCount };
  }
};

/// A segment in equal parts, each of which has the properties of its middle.
struct PartLanes
{
  Lanes firstMiddle;
  Lanes partMm;

  Lanes MiddleOf(int part) const { return this->firstMiddle + float(part) * this->partMm; }
};

/// Segments of a march without shadows.
inline MixedSegment NextSegment(UnmixedLight&)
{
  return {};
}

inline MixedSegment NextSegment(MixedLight& light)
{
  MixedSegment segment;
  segment.byLights = &light.BeginSegment();
  segment.lightCount = light.LightCount();
  return segment;
}

}

}

#endif
