#ifndef Varimarch_Core_Packets_Scatter_HenyeyGreenstein_h
#define Varimarch_Core_Packets_Scatter_HenyeyGreenstein_h

// Twin of Scatter/HenyeyGreenstein.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// The light that goes to the eye: a part that surfaces reflect, and one that matter scatters.
class ScatteredLight
{
public:
  ScatteredLight(const VolumeParameters& parameters, const Lanes3& toEye)
    : parameters(parameters)
    , toEye(toEye)
  {
  }

  /// @param litPart  the part of the light that surfaces receive
  Lanes BySurfaces(Lanes litPart) const
  {
    return (1.0f - this->parameters.scatteredPart) * litPart;
  }

  Lanes ByMatter(const Lanes3& toLight) const
  {
    return this->parameters.scatteredPart *
      HenyeyGreenstein(-Dot(toLight, this->toEye), All(this->parameters.anisotropy));
  }

private:
  const VolumeParameters& parameters;
  Lanes3 toEye;
};

}

}

#endif
