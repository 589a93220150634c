uniform sampler3D volumeTexture;

float ScalarAt(vec3 positionTexture)
{
  return textureLod(volumeTexture, positionTexture, 0.0).r;
}
