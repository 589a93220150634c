// One scalar, seen through the transfer function, and lit.

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec4 optical = Classify(values.scalar);
  return vec4(Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t),
    AtGradient(optical.a, gradients.scalar, 0));
}
