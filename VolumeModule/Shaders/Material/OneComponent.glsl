// One scalar, seen through the transfer function, and lit.

float MaterialExtinction(Values values, Gradients gradients)
{
  return AtGradient(Classify(values.scalar).a, gradients.scalar, 0);
}

vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t)
{
  vec4 optical = Classify(values.scalar);
  return vec4(kept.x * Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t),
    AtGradient(optical.a, gradients.scalar, 0));
}
