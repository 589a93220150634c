#include "Math/Absorption.glsl"
// The mean of opacity times gray over the lengths whose scalars are in a range, in white on black.
// Gray goes from 0 to 1 over the scalars of the volume; the opacity is that over one unit distance.

struct Accumulation
{
  float integral; // [mm]
  float lengthMm; // total length that counts
};

Accumulation BlendBegin()
{
  return Accumulation(0.0, 0.0);
}

Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm)
{
  float opacity = Absorption(min(Classify(scalar).a * opacityUnitDistancesMm.x, 100.0));
  float gray = (scalar - smallestScalars.x) * grayPerScalars.x;
  bool counts = averagedLower.x <= scalar && scalar <= averagedUpper.x;
  float countedMm = counts ? lengthMm : 0.0;
  return Accumulation(sum.integral + opacity * gray * countedMm, sum.lengthMm + countedMm);
}

float BlendState(Accumulation sum)
{
  return 1.0;
}

bool BlendFinished(Accumulation sum)
{
  return false;
}

vec4 BlendResult(Accumulation sum)
{
  float mean = clamp(sum.integral / max(sum.lengthMm, 1e-30), 0.0, 1.0);
  return sum.lengthMm > 0.0 ? vec4(vec3(mean), 1.0) : vec4(0.0);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.integral, sum.lengthMm, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r, kept.g);
}
