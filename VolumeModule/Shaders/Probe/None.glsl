// Fetches are not counted.

void CountFetch() {}

vec4 StoredAt(vec3 placeTexture)
{
  return textureLod(volumeTexture, placeTexture, 0.0);
}

vec4 Probed(vec4 picture)
{
  return picture;
}
