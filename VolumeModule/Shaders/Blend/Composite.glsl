#include "Math/Absorption.glsl"
// Emission and absorption, front to back. Each part of the ray is homogeneous, so that the volume
// rendering integral has a closed form (Max, "Optical models for direct volume rendering", IEEE
// TVCG 1995, eq. 7): the part emits color * absorption and transmits exp(-depth).

struct Accumulation
{
  vec3 color;          // premultiplied
  float transmittance; // fraction of the light from behind that reaches the eye
};

Accumulation BlendBegin()
{
  return Accumulation(vec3(0.0), 1.0);
}

Accumulation BlendPart(Accumulation sum, vec3 color, float depth)
{
  // An opaque material has a huge extinction. Beyond a depth of 100 no light is left in a float.
  float absorbed = Absorption(min(depth, 100.0));
  sum.color += sum.transmittance * absorbed * color;
  sum.transmittance *= 1.0 - absorbed;
  return sum;
}

float BlendState(Accumulation sum)
{
  return sum.transmittance;
}

bool BlendFinished(Accumulation sum)
{
  return sum.transmittance < earlyTerminationTransmittance;
}

vec4 BlendResult(Accumulation sum)
{
  return vec4(sum.color, 1.0 - sum.transmittance);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.color, 1.0 - sum.transmittance);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.rgb, 1.0 - kept.a);
}
