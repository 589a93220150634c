// The integral of opacity times gray over lengths in unit distances, at most 1, in white on black.
// Gray goes from 0 to 1 over the scalars of the volume.

struct Accumulation
{
  float integral; // [mm]
};

uniform float smallestScalar;
uniform float grayPerScalar;
uniform float opacityUnitDistanceMm;

Accumulation BlendBegin()
{
  return Accumulation(0.0);
}

Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm)
{
  float opacity = Absorption(min(Classify(scalar).a * opacityUnitDistanceMm, 100.0));
  float gray = (scalar - smallestScalar) * grayPerScalar;
  return Accumulation(sum.integral + opacity * gray * lengthMm);
}

float BlendState(Accumulation sum)
{
  return 1.0;
}

bool BlendFinished(Accumulation sum)
{
  return sum.integral >= opacityUnitDistanceMm;
}

vec4 BlendResult(Accumulation sum)
{
  return vec4(vec3(clamp(sum.integral / opacityUnitDistanceMm, 0.0, 1.0)), 1.0);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.integral, 0.0, 0.0, 0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.r);
}
