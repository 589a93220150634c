// Transfer function as a table of its means between two scalars (Core/Look/PreIntegratedTable):
// emission and extinction. It covers the scalars between which the function changes. The part of a
// piece that lies below or above them has the properties of the first or last, and weighs as much
// as its length.

vec4 ClassifyBetween(float startScalar, float endScalar)
{
  float last = lastTableIndices.x;
  float start = startScalar * tableScales.x + tableBiases.x;
  float end = endScalar * tableScales.x + tableBiases.x;
  vec2 covered = clamp(vec2(start, end), 0.0, last);
  vec4 inside = textureLod(preIntegratedTable, (covered + 0.5) / (last + 1.0), 0.0);

  float lower = min(start, end);
  float upper = max(start, end);
  float extent = max(upper - lower, 1e-12);
  float below = upper <= 0.0 ? 1.0 : clamp(-lower / extent, 0.0, 1.0);
  float above = lower >= last ? 1.0 : clamp((upper - last) / extent, 0.0, 1.0);
  vec3 extinctions =
    vec3(max(1.0 - below - above, 0.0) * inside.a, below * opticalBelow.a, above * opticalAbove.a);
  float extinction = extinctions.x + extinctions.y + extinctions.z;
  vec3 emission = max(1.0 - below - above, 0.0) * inside.rgb +
    mat2x3(opticalBelow.rgb, opticalAbove.rgb) * extinctions.yz;
  return vec4(emission / max(extinction, 1e-30), extinction);
}
