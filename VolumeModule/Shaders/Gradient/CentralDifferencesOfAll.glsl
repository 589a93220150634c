// The differences between the values of all components one voxel to either side. They are 0 if a
// voxel that they depend on is not finite.

mat4x3 GradientsAllAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  mat3x4 differences = mat3x4(TexelAt(positionTexture + x) - TexelAt(positionTexture - x),
    TexelAt(positionTexture + y) - TexelAt(positionTexture - y),
    TexelAt(positionTexture + z) - TexelAt(positionTexture - z));
  return HasGradient(positionTexture) ? transpose(differences) : mat4x3(0.0);
}
