// Trilinear or nearest, as texels are filtered.

vec4 TexelAt(vec3 positionTexture)
{
  return StoredAt(VoxelPlace(positionTexture));
}

vec4 TexelForDifference(vec3 positionTexture)
{
  return StoredForDifference(VoxelPlace(positionTexture));
}

float ScalarAt(vec3 positionTexture)
{
  return TexelAt(positionTexture).r;
}
