#ifndef Varimarch_Core_Packets_GradientOpacity_LabelTables_h
#define Varimarch_Core_Packets_GradientOpacity_LabelTables_h

// Twin of GradientOpacity/LabelTables.glsl.

#include "Core/Packets/GradientOpacity/Table.h"

namespace varimarch
{

namespace
{

inline Lanes AtGradientOfRows(
  const PacketScene& scene, Lanes extinction, const Lanes3& gradient, const IntNumbers& row)
{
  const int entries = int(scene.parameters.lastGradientEntry) + 1;
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int lane, int index)
    {
      const int table = row.of[lane] / 4;
      return scene.textures.gradientOpacityTable[table * entries + index][row.of[lane] % 4];
    });
}

}

}

#endif
