#include "Math/PreIntegration.glsl"
// A transfer function as a table of its means between two scalars (Core/Look/PreIntegratedTable):
// emission and extinction. The table covers the scalars between which the function changes.

vec4 ClassifyBetween(float startScalar, float endScalar)
{
  float last = lastTableIndices.x;
  float start = startScalar * tableScales.x + tableBiases.x;
  float end = endScalar * tableScales.x + tableBiases.x;
  vec2 covered = clamp(vec2(start, end), 0.0, last);
  vec4 inside = textureLod(preIntegratedTable, (covered + 0.5) / (last + 1.0), 0.0);
  vec4 mean = WithEnds(inside, start, end, last, emissionBelow, emissionAbove);
  return vec4(mean.rgb / max(mean.a, 1e-30), mean.a);
}
