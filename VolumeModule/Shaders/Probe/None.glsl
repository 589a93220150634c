// Nothing is observed.

vec4 TexelAt(vec3 positionTexture)
{
  return textureLod(volumeTexture, VoxelPlace(positionTexture), 0.0);
}

float ScalarAt(vec3 positionTexture)
{
  return TexelAt(positionTexture).r;
}

vec4 Probed(vec4 picture)
{
  return picture;
}
