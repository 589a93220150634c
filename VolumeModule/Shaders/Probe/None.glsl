// Fetches are not counted.

void CountFetch() {}

vec4 StoredAt(vec3 placeTexture)
{
  return Filtered(volumeTexture, placeTexture);
}

vec4 StoredForDifference(vec3 placeTexture)
{
  return FilteredForDifference(volumeTexture, placeTexture);
}

vec4 Probed(vec4 picture)
{
  return picture;
}
