// Optical depth of a material by its opacity and its transparency, which is 1 - opacity: an
// accurate -log(1 - opacity). GLSL has no log1p: below 1/8 the series is within 6e-7 of the true
// value, relatively, where the logarithm has lost the digits.
float DepthOf(float opacity, float transparency)
{
  float series = opacity * 0.14285714f + 0.16666667f;
  series = series * opacity + 0.2f;
  series = series * opacity + 0.25f;
  series = series * opacity + 0.33333333f;
  series = series * opacity + 0.5f;
  series = series * opacity + 1.0f;
  return opacity < 0.125f ? series * opacity : -log(max(transparency, 1e-35f));
}

// Extinction of a material that has this opacity over a unit distance.
float ExtinctionOf(float opacity, float unitDistanceMm)
{
  return opacity < 1.0f ? DepthOf(opacity, 1.0f - opacity) / unitDistanceMm : 1e30f;
}

// Extinction of a material whose opacity over a unit distance is multiplied by a factor in [0, 1]:
// -log(1 - factor * opacity) / unit distance, where opacity = 1 - exp(-extinction * unit distance).
// The factor thus acts on the opacity of a unit distance, whatever the steps are. An opaque
// material stays opaque where the factor is 1. Needs Absorption.glsl.
float WithOpacityFactor(float extinction, float unitDistanceMm, float factor)
{
  float depth = min(extinction * unitDistanceMm, 80.0f);
  float opacity = factor * Absorption(depth);
  float transparency = (1.0f - factor) + factor * exp(-depth);
  return factor < 1.0f ? DepthOf(opacity, transparency) / unitDistanceMm : extinction;
}
