#include "Math/Absorption.glsl"
// The largest scalar along the ray, seen through the transfer function, with the opacity over one
// unit distance, whatever the length of the ray. A ray without a sample is transparent.

struct Accumulation
{
  float largest;
};

Accumulation BlendBegin()
{
  return Accumulation(smallestScalars.x - 1.0); // beyond all scalars: no sample yet
}

bool HasSample(Accumulation sum)
{
  return sum.largest > smallestScalars.x - 0.5;
}

Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm)
{
  return Accumulation(max(sum.largest, scalar));
}

float BlendState(Accumulation sum)
{
  return sum.largest;
}

bool BlendFinished(Accumulation sum)
{
  return sum.largest >= largestScalars.x;
}

vec4 BlendResult(Accumulation sum)
{
  vec4 optical = Classify(sum.largest);
  float opacity = Absorption(min(optical.a * opacityUnitDistancesMm.x, 100.0));
  return HasSample(sum) ? vec4(optical.rgb * opacity, opacity) : vec4(0.0);
}

vec4 BlendKept(Accumulation sum)
{
  return HasSample(sum) ? vec4(sum.largest - smallestScalars.x, 1.0, 0.0, 0.0) : vec4(0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return kept.g > 0.0 ? Accumulation(kept.r + smallestScalars.x) : BlendBegin();
}
