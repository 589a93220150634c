#include "Math/Absorption.glsl"
// The smallest scalar along the ray, seen through the transfer function, with the opacity over one
// unit distance, whatever the length of the ray. A ray without a sample is transparent.

struct Accumulation
{
  float smallest;
};

Accumulation BlendBegin()
{
  return Accumulation(largestScalars.x + 1.0); // beyond all scalars: no sample yet
}

bool HasSample(Accumulation sum)
{
  return sum.smallest < largestScalars.x + 0.5;
}

Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm)
{
  return Accumulation(min(sum.smallest, scalar));
}

float BlendState(Accumulation sum)
{
  return sum.smallest;
}

bool BlendFinished(Accumulation sum)
{
  return sum.smallest <= smallestScalars.x;
}

vec4 BlendResult(Accumulation sum)
{
  vec4 optical = Classify(sum.smallest);
  float opacity = Absorption(min(optical.a * opacityUnitDistancesMm.x, 100.0));
  return HasSample(sum) ? vec4(optical.rgb * opacity, opacity) : vec4(0.0);
}

vec4 BlendKept(Accumulation sum)
{
  return HasSample(sum) ? vec4(sum.smallest - largestScalars.x, 1.0, 0.0, 0.0) : vec4(0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return kept.g > 0.0 ? Accumulation(kept.r + largestScalars.x) : BlendBegin();
}
