#include "Math/Gradients.glsl"
// Voxels without a label have a function of value and gradient magnitude, and labels have tables.

vec4 OfRow(int row, Values values, Gradients gradients)
{
  if (row == 0)
  {
    return ClassifyTwo(vec2(values.scalar * placeFromScalar.x + placeFromScalar.y,
      GradientIndex(gradients.scalar, spacingFactors, placePerGradient, 1.0)));
  }
  vec4 optical = ClassifyBy(row, values.scalar);
  return vec4(optical.rgb, AtGradient(optical.a, gradients.scalar, row));
}
