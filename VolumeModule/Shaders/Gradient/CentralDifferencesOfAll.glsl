// The differences between the values of all components one voxel to either side. They are 0 if a
// voxel that they depend on is not finite.

mat4x3 GradientsAllAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  mat3x4 differences =
    mat3x4(TexelForDifference(positionTexture + x) - TexelForDifference(positionTexture - x),
      TexelForDifference(positionTexture + y) - TexelForDifference(positionTexture - y),
      TexelForDifference(positionTexture + z) - TexelForDifference(positionTexture - z));
  return HasGradient(positionTexture) ? transpose(differences) : mat4x3(0.0);
}
