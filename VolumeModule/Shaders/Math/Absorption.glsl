// The part of light absorbed over an optical depth: 1 - exp(-depth), without cancellation.
// GLSL has no expm1; below 1/4 the series to the sixth power is within 6e-7 of the true value
// relative, where 1 - exp(-depth) has lost the digits.
float Absorption(float depth)
{
  float series = depth *
    (1.0f -
      depth *
        (0.5f -
          depth *
            (0.16666667f -
              depth * (0.041666667f - depth * (0.0083333333f - depth * 0.0013888889f)))));
  return depth < 0.25f ? series : 1.0f - exp(-depth);
}
