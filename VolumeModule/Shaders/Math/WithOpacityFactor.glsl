// Extinction of a material whose opacity over a unit distance is multiplied by a factor in [0,1]:
// -log(1 - factor * opacity) / unit distance, where opacity = 1 - exp(-extinction * unit distance).
// So the factor acts on the opacity of a unit distance, whatever the steps are. GLSL has no log1p;
// below 1/8 the series is within 6e-7 of the true value relative, where the logarithm has lost the
// digits. An opaque material stays opaque where the factor is 1.
float WithOpacityFactor(float extinction, float unitDistanceMm, float factor)
{
  float depth = min(extinction * unitDistanceMm, 80.0f);
  float opacity = factor * Absorption(depth);
  float series = opacity *
    (1.0f +
      opacity *
        (0.5f +
          opacity *
            (0.33333333f +
              opacity *
                (0.25f + opacity * (0.2f + opacity * (0.16666667f + opacity * 0.14285714f))))));
  float transparency = (1.0f - factor) + factor * exp(-depth);
  float newDepth = opacity < 0.125f ? series : -log(max(transparency, 1e-35f));
  return factor < 1.0f ? newDepth / unitDistanceMm : extinction;
}
