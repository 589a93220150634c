// One scalar and the magnitude of its gradient, seen through a transfer function of two values.
// Gradients are measured as VTK does: in units of the data per mean spacing of the voxels, from 0
// to a quarter of the range.

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  float magnitude = length(spacingFactors * gradients.scalar);
  vec4 optical = ClassifyTwo(
    vec2(values.scalar * placeFromScalar.x + placeFromScalar.y, magnitude * placePerGradient));
  return vec4(Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t), optical.a);
}
