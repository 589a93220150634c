#include "Math/Absorption.glsl"
// The largest or smallest values along the ray, seen through the transfer functions: colour and
// opacity of each component over its unit distance, whatever the length of the ray. They add up to
// at most 1, as light does, because the extremes of several components lie at different positions.
// A ray without a sample is transparent.

struct Accumulation
{
  vec4 extremes;
  bool any; // true if there was a sample
};

// Values that are no more extreme than any other.
vec4 LeastExtremes()
{
  return sense > 0.0 ? smallestScalars : largestScalars;
}

Accumulation BlendBegin()
{
  return Accumulation(LeastExtremes(), false);
}

Accumulation BlendTexel(Accumulation sum, vec4 texel, float lengthMm)
{
  return Accumulation(sum.any ? MoreExtreme(sum.extremes, texel, sense) : texel, true);
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
  vec4 picture = vec4(0.0);
  for (int part = 0; part < materialCount; ++part)
  {
    vec4 optical = PartOptical(sum.extremes, part);
    float opacity = Absorption(min(optical.a * opacityUnitDistancesMm[part], 100.0));
    picture += partWeights[part] * opacity * vec4(optical.rgb, 1.0);
  }
  return sum.any ? min(picture, 1.0) : vec4(0.0);
}

// Without a sample the kept numbers are 0; those of a value are at least 1.
vec4 BlendKept(Accumulation sum)
{
  return sum.any ? sense * (sum.extremes - LeastExtremes()) + 1.0 : vec4(0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(sense * (kept - 1.0) + LeastExtremes(), kept.x > 0.0);
}
