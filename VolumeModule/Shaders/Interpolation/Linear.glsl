// Trilinear or nearest, as the texture itself is filtered.

vec4 TexelAt(vec3 positionTexture)
{
  return StoredAt(VoxelPlace(positionTexture));
}

float ScalarAt(vec3 positionTexture)
{
  return TexelAt(positionTexture).r;
}
