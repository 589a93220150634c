#ifndef Varimarch_Core_Packets_Classify_PreIntegrated_h
#define Varimarch_Core_Packets_Classify_PreIntegrated_h

// Twin of Classify/PreIntegrated.glsl.

#include "Core/Packets/PacketTables.h"

namespace varimarch
{

namespace
{

inline Optical ClassifyBetween(const PacketLook& look, Lanes startValue, Lanes endValue)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes start = startValue * look.indexScale + look.indexOffset;
  const Lanes end = endValue * look.indexScale + look.indexOffset;
  Optical emission = Interpolated(look.table, glm::ivec2(look.lastIndex + 1),
    Clamp(start, Lanes{}, last), Clamp(end, Lanes{}, last));
  if (Any(LaneMask(Min(start, end) < 0.0f) | LaneMask(Max(start, end) > last)))
  {
    const Lanes4 mean =
      WithEnds({ emission.color.x, emission.color.y, emission.color.z, emission.extinction }, start,
        end, last, AllOf4(look.emissionBelow), AllOf4(look.emissionAbove));
    emission = { { mean.x, mean.y, mean.z }, mean.w };
  }
  return { (1.0f / Max(emission.extinction, All(1e-30f))) * emission.color, emission.extinction };
}

}

}

#endif
