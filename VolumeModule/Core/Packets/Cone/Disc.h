#ifndef Varimarch_Core_Packets_Cone_Disc_h
#define Varimarch_Core_Packets_Cone_Disc_h

// Twin of Cone/Disc.glsl.

#include "Core/Geometry/LightCone.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// The mean of the light over the directions in a cone.
/// @param height       1 - the cosine of the cone's half angle
/// @param transmitted  receives a function that turns unit vectors to the middle of the light into
/// those to another place in it, and returns the light that arrives from there
template <class Transmitted>
Lanes MeanOverCone(float height, Transmitted transmitted)
{
  Lanes sum = {};
  for (const DiscPoint& point : DiscQuadrature())
  {
    const auto turned = [&](const Lanes3& towards)
    { return DirectionInCone(towards, All(height), All(float(point.x)), All(float(point.y))); };
    sum = sum + float(point.weight) * transmitted(turned);
  }
  return sum;
}

}

}

#endif
