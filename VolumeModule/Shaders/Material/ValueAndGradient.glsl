#include "Math/Gradients.glsl"
// One scalar and the magnitude of its gradient, seen through a transfer function of both. The
// function has the magnitude from 0 to a quarter of the range.

vec4 LookOf(Values values, Gradients gradients)
{
  return ClassifyTwo(vec2(values.scalar * placeFromScalar.x + placeFromScalar.y,
    GradientIndex(gradients.scalar, spacingFactors, placePerGradient, 1.0)));
}

float MaterialExtinction(Values values, Gradients gradients)
{
  return LookOf(values, gradients).a;
}

vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t)
{
  vec4 optical = LookOf(values, gradients);
  return vec4(kept.x * Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t), optical.a);
}
