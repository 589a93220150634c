// Each row of a label map has a table of its own, also the first one, of voxels without a label.

vec4 OfRow(int row, Values values, Gradients gradients)
{
  vec4 optical = ClassifyBy(row, values.scalar);
  return vec4(optical.rgb, AtGradient(optical.a, gradients.scalar, row));
}
