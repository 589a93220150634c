#include "Math/Absorption.glsl"
// The integral of opacity times gray of each component, with lengths in unit distances. The pixel
// is their weighted sum, at most 1, in white on black. Gray goes from 0 to 1 over the values of the
// component. A ray without a sample is transparent.

struct Accumulation
{
  float sum;
  float lengthMm; // total length of the samples
};

Accumulation BlendBegin()
{
  return Accumulation(0.0, 0.0);
}

Accumulation BlendTexel(Accumulation sum, vec4 texel, float lengthMm)
{
  for (int part = 0; part < materialCount; ++part)
  {
    float unitMm = opacityUnitDistancesMm[part];
    float opacity = Absorption(min(PartOptical(texel, part).a * unitMm, 100.0));
    float gray = (texel[part] - smallestScalars[part]) * grayPerScalars[part];
    sum.sum += partWeights[part] * opacity * gray * lengthMm / unitMm;
  }
  sum.lengthMm += lengthMm;
  return sum;
}

float BlendState(Accumulation sum)
{
  return 1.0;
}

bool BlendFinished(Accumulation sum)
{
  return sum.sum >= 1.0;
}

vec4 BlendResult(Accumulation sum)
{
  return sum.lengthMm > 0.0 ? vec4(vec3(clamp(sum.sum, 0.0, 1.0)), 1.0) : vec4(0.0);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.sum, sum.lengthMm, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r, kept.g);
}
