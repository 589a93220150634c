// One scalar and the magnitude of its gradient, seen through a transfer function of two values.
// Gradients are measured as VTK does: in units of the data per mean spacing of the voxels, from 0
// to a quarter of the range.

uniform vec4 reflectance;
uniform vec2 placeFromScalar; // scale and bias: texture value -> [0,1] in its range
uniform vec3 spacingFactors;  // mean spacing over twice the spacing along each axis
uniform float placePerGradient;

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  float magnitude = length(spacingFactors * gradients.scalar);
  vec4 optical = ClassifyTwo(
    vec2(values.scalar * placeFromScalar.x + placeFromScalar.y, magnitude * placePerGradient));
  return vec4(Shade(optical.rgb, gradients.scalar, reflectance, ray, t), optical.a);
}
