// The smallest scalar along the ray, seen through the transfer function: its opacity over one unit
// distance, whatever the length of the ray.

struct Accumulation
{
  float smallest;
};

uniform float smallestScalar;
uniform float largestScalar;
uniform float opacityUnitDistanceMm;

Accumulation BlendBegin()
{
  return Accumulation(largestScalar);
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
  return sum.smallest <= smallestScalar;
}

vec4 BlendResult(Accumulation sum)
{
  vec4 optical = Classify(sum.smallest);
  float opacity = Absorption(min(optical.a * opacityUnitDistanceMm, 100.0));
  return vec4(optical.rgb * opacity, opacity);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.smallest - largestScalar, 0.0, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r + largestScalar);
}
