// Like CentralDifferences.glsl, but positions that clipping planes cut away all have the same
// scalar, so that a cut is a surface with a normal of its own.

float ScalarBeside(vec3 positionTexture)
{
  vec3 positionGrid = positionTexture / voxelCountInverse - 0.5 + firstVoxelGrid;
  return IsClipped(positionGrid) ? clippedScalar : TexelForDifference(positionTexture).r;
}

vec3 GradientAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  vec3 gradient = vec3(ScalarBeside(positionTexture + x) - ScalarBeside(positionTexture - x),
    ScalarBeside(positionTexture + y) - ScalarBeside(positionTexture - y),
    ScalarBeside(positionTexture + z) - ScalarBeside(positionTexture - z));
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}
