#include "Math/Absorption.glsl"
// The integral of opacity times gray along the ray, with lengths in unit distances, and at most 1,
// in white on black. Gray goes from 0 to 1 over the scalars of the volume. A ray without a
// sample is transparent.

struct Accumulation
{
  float integral; // [mm]
  float lengthMm; // total length of the samples
};

Accumulation BlendBegin()
{
  return Accumulation(0.0, 0.0);
}

Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm)
{
  float opacity = Absorption(min(Classify(scalar).a * opacityUnitDistancesMm.x, 100.0));
  float gray = (scalar - smallestScalars.x) * grayPerScalars.x;
  return Accumulation(sum.integral + opacity * gray * lengthMm, sum.lengthMm + lengthMm);
}

float BlendState(Accumulation sum)
{
  return 1.0;
}

bool BlendFinished(Accumulation sum)
{
  return sum.integral >= opacityUnitDistancesMm.x;
}

vec4 BlendResult(Accumulation sum)
{
  float white = clamp(sum.integral / opacityUnitDistancesMm.x, 0.0, 1.0);
  return sum.lengthMm > 0.0 ? vec4(vec3(white), 1.0) : vec4(0.0);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.integral, sum.lengthMm, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r, kept.g);
}
