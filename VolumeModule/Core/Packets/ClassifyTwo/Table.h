#ifndef Varimarch_Core_Packets_ClassifyTwo_Table_h
#define Varimarch_Core_Packets_ClassifyTwo_Table_h

// Twin of ClassifyTwo/Table.glsl, for a value and the magnitude of its gradient.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/PacketTables.h"

namespace varimarch
{

namespace
{

/// Its arguments are copies, so that those of a march stay in registers.
[[gnu::noinline]] FLATTENED inline Optical ClassifyTwo(
  const PacketScene& scene, Lanes value, Lanes3 gradient)
{
  const VolumeParameters& parameters = scene.parameters;
  const glm::ivec2 size(parameters.twoValueTableSize);
  const auto indexOf = [](Lanes place, int size)
  {
    const Lanes last = All(float(size - 1));
    return TableIndex(place, last, Lanes{}, last);
  };
  const Lanes valuePlace = value * parameters.placeFromScalar.x + parameters.placeFromScalar.y;
  const Lanes gradientPlace = GradientIndex(
    gradient, AllOf3(parameters.spacingFactors), All(parameters.placePerGradient), All(1.0f));
  Optical found = Interpolated(scene.textures.twoValueTable.Texels<glm::vec4>(), size,
    indexOf(valuePlace, size.x), indexOf(gradientPlace, size.y));
  found.extinction = ExtinctionOf(found.extinction, All(parameters.opacityUnitDistancesMm.x));
  return found;
}

}

}

#endif
