// The volume has a value everywhere.

bool HasValue(vec3 positionTexture)
{
  return true;
}

bool HasGradient(vec3 positionTexture)
{
  return true;
}

Accumulation MarchVolume(Ray ray, Interval inside, Accumulation sum)
{
  return March(ray, inside, sum);
}
