#ifndef Varimarch_Core_Packets_Reach_Light_h
#define Varimarch_Core_Packets_Reach_Light_h

// The parts of the lights that reach a point: struct Reach of Shaders/VolumeSlots.glsl.

#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// Lights without shadows, which reach every point.
struct AllLight
{
};

inline AllLight Mix(AllLight, AllLight, Lanes)
{
  return {};
}

inline AllLight Select(LaneMask, AllLight, AllLight)
{
  return {};
}

inline Lanes2 Reached(const Lanes2& reflected, AllLight, int)
{
  return reflected;
}

/// Lights with shadows.
struct PartialLight
{
  static constexpr int Most = MostShadows; ///< lights beyond these cast no shadow
  Lanes of[Most] = {};
};

inline PartialLight Mix(const PartialLight& a, const PartialLight& b, Lanes part)
{
  PartialLight mixed;
  for (int light = 0; light < PartialLight::Most; ++light)
  {
    mixed.of[light] = Mix(a.of[light], b.of[light], part);
  }
  return mixed;
}

inline PartialLight Select(LaneMask mask, const PartialLight& yes, const PartialLight& no)
{
  PartialLight selected;
  for (int light = 0; light < PartialLight::Most; ++light)
  {
    selected.of[light] = Select(mask, yes.of[light], no.of[light]);
  }
  return selected;
}

/// @param light  in the order of lightTexels
inline Lanes2 Reached(const Lanes2& reflected, const PartialLight& reach, int light)
{
  return light < PartialLight::Most
    ? Lanes2(reach.of[light] * reflected.x, reach.of[light] * reflected.y)
    : reflected;
}

}

}

#endif
