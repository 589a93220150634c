#include "Math/Absorption.glsl"
// The mean of opacity times gray of each component, over the lengths whose values are in a range.
// The pixel is their weighted sum, in white on black. Gray goes from 0 to 1 over the values of the
// component; the opacity is that over one unit distance.

struct Accumulation
{
  vec4 integrals; // [mm]
  vec4 lengthsMm; // total length that counts
};

Accumulation BlendBegin()
{
  return Accumulation(vec4(0.0), vec4(0.0));
}

Accumulation BlendTexel(Accumulation sum, vec4 texel, float lengthMm)
{
  for (int part = 0; part < materialCount; ++part)
  {
    float depth = PartOptical(texel, part).a * opacityUnitDistancesMm[part];
    float opacity = Absorption(min(depth, 100.0));
    float gray = (texel[part] - smallestScalars[part]) * grayPerScalars[part];
    bool counts = averagedLower[part] <= texel[part] && texel[part] <= averagedUpper[part];
    float countedMm = counts ? lengthMm : 0.0;
    sum.integrals[part] += opacity * gray * countedMm;
    sum.lengthsMm[part] += countedMm;
  }
  return sum;
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
  float mean = 0.0;
  float counted = 0.0;
  for (int part = 0; part < materialCount; ++part)
  {
    mean += partWeights[part] * sum.integrals[part] / max(sum.lengthsMm[part], 1e-30);
    counted += sum.lengthsMm[part];
  }
  return counted > 0.0 ? vec4(vec3(clamp(mean, 0.0, 1.0)), 1.0) : vec4(0.0);
}
