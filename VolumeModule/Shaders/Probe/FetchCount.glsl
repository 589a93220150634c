// Draws the number of a ray's fetches of the volume and its gradients instead of its colour: in
// red, not scaled.

float fetches = 0.0;

void CountFetch()
{
  fetches += 1.0;
}

vec4 StoredAt(vec3 placeTexture)
{
  CountFetch();
  return Filtered(volumeTexture, placeTexture);
}

vec4 StoredForDifference(vec3 placeTexture)
{
  CountFetch();
  return FilteredForDifference(volumeTexture, placeTexture);
}

vec4 Probed(vec4 picture)
{
  return vec4(fetches, 0.0, 0.0, 1.0);
}
