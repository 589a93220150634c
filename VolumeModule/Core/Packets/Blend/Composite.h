#ifndef Varimarch_Core_Packets_Blend_Composite_h
#define Varimarch_Core_Packets_Blend_Composite_h

// Twin of Blend/Composite.glsl.

#include "Core/Packets/PacketTables.h"

namespace varimarch
{

namespace
{

/// The emission and absorption along rays, front to back.
struct PacketSum
{
  Lanes3 color = { Lanes{}, Lanes{}, Lanes{} }; ///< premultiplied
  Lanes transmittance = All(1.0f);
  Lanes opticalDepth = {}; ///< optical depth of all parts; it is known before the transmittance

  void Add(const Optical& optical, Lanes lengthMm)
  {
    const Lanes depth = Min(optical.extinction * lengthMm, All(100.0f));
    this->opticalDepth += depth;
    const Lanes seen = this->transmittance * Absorption(depth);
    this->color = this->color + seen * optical.color;
    this->transmittance -= seen;
  }
};

inline PacketSum Select(LaneMask mask, const PacketSum& yes, const PacketSum& no)
{
  return { Select(mask, yes.color, no.color), Select(mask, yes.transmittance, no.transmittance),
    Select(mask, yes.opticalDepth, no.opticalDepth) };
}

}

}

#endif
