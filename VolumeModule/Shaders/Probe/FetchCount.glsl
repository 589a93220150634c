// Draws, in place of the picture, how often its ray has read the volume: red, not scaled.

float fetches = 0.0;

vec4 TexelAt(vec3 positionTexture)
{
  fetches += 1.0;
  return textureLod(volumeTexture, VoxelPlace(positionTexture), 0.0);
}

float ScalarAt(vec3 positionTexture)
{
  return TexelAt(positionTexture).r;
}

vec4 Probed(vec4 picture)
{
  return vec4(fetches, 0.0, 0.0, 1.0);
}
