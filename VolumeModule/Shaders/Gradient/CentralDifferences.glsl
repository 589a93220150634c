// The difference between the scalars one voxel to either side, which is twice the gradient. It is 0
// if a voxel that it depends on is not finite.

vec3 GradientAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  vec3 gradient = vec3(ScalarAt(positionTexture + x) - ScalarAt(positionTexture - x),
    ScalarAt(positionTexture + y) - ScalarAt(positionTexture - y),
    ScalarAt(positionTexture + z) - ScalarAt(positionTexture - z));
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}
