// Nothing is observed.

float ScalarAt(vec3 positionTexture)
{
  return textureLod(volumeTexture, positionTexture, 0.0).r;
}

vec4 Probed(vec4 picture)
{
  return picture;
}
