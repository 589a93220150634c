// The largest scalar along the ray, seen through the transfer function: its opacity over one unit
// distance, whatever the length of the ray.

struct Accumulation
{
  float largest;
};

uniform float smallestScalar;
uniform float largestScalar;
uniform float opacityUnitDistanceMm;

Accumulation BlendBegin()
{
  return Accumulation(smallestScalar);
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
  return sum.largest >= largestScalar;
}

vec4 BlendResult(Accumulation sum)
{
  vec4 optical = Classify(sum.largest);
  float opacity = Absorption(min(optical.a * opacityUnitDistanceMm, 100.0));
  return vec4(optical.rgb * opacity, opacity);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.largest - smallestScalar, 0.0, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r + smallestScalar);
}
