#ifndef Varimarch_Core_Packets_GradientOpacity_Table_h
#define Varimarch_Core_Packets_GradientOpacity_Table_h

// Twin of GradientOpacity/Table.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// Multiplies the opacity over a unit distance by a function of the gradient.
/// @param factorOf  (lane, index) -> the factor of an entry of the table
template <class FactorOf>
Lanes WithGradientOpacity(
  const PacketScene& scene, Lanes extinction, const Lanes3& gradient, FactorOf factorOf)
{
  const VolumeParameters& parameters = scene.parameters;
  const int component = scene.constituent.component;
  const Lanes last = All(parameters.lastGradientEntry);
  const Lanes place = GradientIndex(gradient, AllOf3(parameters.spacingFactors),
    All(parameters.entriesPerGradient[component]), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const auto factors = [&](int next)
  { return LanesOf([&](int lane) { return factorOf(lane, index.of[lane] + next); }); };
  return WithOpacityFactor(extinction, All(parameters.opacityUnitDistancesMm[component]),
    Mix(factors(0), factors(1), place - below));
}

inline Lanes AtGradient(const PacketScene& scene, Lanes extinction, const Lanes3& gradient)
{
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int, int index)
    { return scene.textures.gradientOpacityTable[index][scene.constituent.component]; });
}

}

}

#endif
