// The derivatives of the spline itself, times 2: like differences over two voxels, which everything
// that uses gradients expects.

vec3 GradientAt(vec3 positionTexture)
{
  return 2.0 *
    vec3(SlopeAlong(vec3(1.0, 0.0, 0.0), positionTexture).r,
      SlopeAlong(vec3(0.0, 1.0, 0.0), positionTexture).r,
      SlopeAlong(vec3(0.0, 0.0, 1.0), positionTexture).r);
}
