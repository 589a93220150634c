#ifndef Varimarch_Core_Packets_Crop_Regions_h
#define Varimarch_Core_Packets_Crop_Regions_h

// Twin of Crop/Regions.glsl.

#include "Core/Packets/PacketRays.h"

namespace varimarch
{

namespace
{

/// Six planes cut rays into pieces, each of which lies in one region.
class CroppedPieces
{
public:
  CroppedPieces(const PacketScene& scene, const PacketRays& rays)
    : parameters(scene.rays)
    , rays(rays)
    , t(rays.enter)
  {
    for (int i = 0; i < 6; ++i)
    {
      const glm::vec4& plane = this->parameters.croppingPlanes[i];
      this->crossings[i] =
        -BeyondPlane(plane, rays.originGrid) / ApproachToPlane(plane, rays.directionGrid);
    }
  }

  /// See MarchPieces: all pieces that are drawn and follow each other.
  PacketRays Next(LaneMask mask)
  {
    PacketRays drawn = this->rays;
    drawn.enter = this->t;
    LaneMask isFound = {};
    while (Any(mask))
    {
      const Lanes end = this->NextCrossing(this->t);
      const LaneMask isDrawn = this->IsDrawn(0.5f * (this->t + end));
      mask &= isDrawn | ~isFound;
      this->t = Select(mask, end, this->t);
      isFound |= mask & isDrawn;
      drawn.enter = Select(isFound, drawn.enter, this->t);
      mask &= LaneMask(this->t < this->rays.exit);
    }
    drawn.exit = this->t;
    return drawn;
  }

  /// The rays whose region at a place is drawn.
  LaneMask IsDrawn(Lanes place) const
  {
    const Lanes3 position = this->rays.At(place);
    IntLanes region = {};
    for (int axis = 2; axis >= 0; --axis)
    {
      const shader::vec4* const planes = this->parameters.croppingPlanes + 2 * axis;
      const LaneMask isBeyondLower = LaneMask(BeyondPlane(planes[0], position) >= 0.0f);
      const LaneMask isBeyondUpper = LaneMask(BeyondPlane(planes[1], position) >= 0.0f);
      region = 3 * region - isBeyondLower - isBeyondUpper; // a mask is -1
    }
    return LaneMask((AllInt(this->parameters.croppingRegions) >> region & 1) != 0);
  }

  /// The next place at which rays meet a plane, or their exit.
  Lanes NextCrossing(Lanes from) const
  {
    Lanes next = this->rays.exit;
    for (const Lanes& crossing : this->crossings)
    {
      next = Select(LaneMask(crossing > from), Min(crossing, next), next);
    }
    return next;
  }

private:
  const RayParameters& parameters;
  const PacketRays& rays;
  Lanes t; ///< the end of the last piece
  Lanes crossings[6];
};

}

}

#endif
