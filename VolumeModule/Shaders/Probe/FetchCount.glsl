// Draws the number of a ray's fetches of the volume instead of its colour: in red, not scaled.

float fetches = 0.0;

vec4 StoredAt(vec3 placeTexture)
{
  fetches += 1.0;
  return textureLod(volumeTexture, placeTexture, 0.0);
}

vec4 Probed(vec4 picture)
{
  return vec4(fetches, 0.0, 0.0, 1.0);
}
