// The largest values along the ray, or the smallest, seen through the transfer functions: colour
// and opacity of each component over its unit distance, whatever the length of the ray, are added
// up to 1, as lights are, for the extremes of several components lie at several places. A ray
// without any sample is transparent.

struct Accumulation
{
  vec4 extremes;
  bool any; // whether there was a sample
};

// Every value is at least as extreme.
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

// Nothing is kept as 0, and no value as less than 1.
vec4 BlendKept(Accumulation sum)
{
  return sum.any ? sense * (sum.extremes - LeastExtremes()) + 1.0 : vec4(0.0);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(sense * (kept - 1.0) + LeastExtremes(), kept.x > 0.0);
}
