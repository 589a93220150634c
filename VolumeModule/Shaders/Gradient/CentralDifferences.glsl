// The difference between the scalars one voxel to either side, which is twice the gradient. It is 0
// if a voxel that it depends on is not finite.

vec3 GradientAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  vec3 gradient =
    vec3(TexelForDifference(positionTexture + x).r - TexelForDifference(positionTexture - x).r,
      TexelForDifference(positionTexture + y).r - TexelForDifference(positionTexture - y).r,
      TexelForDifference(positionTexture + z).r - TexelForDifference(positionTexture - z).r);
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}
