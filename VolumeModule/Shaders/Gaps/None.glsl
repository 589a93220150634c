// The volume has a value everywhere.

bool HasGradient(vec3 positionTexture)
{
  return true;
}

Accumulation MarchVolume(Ray ray, Interval inside)
{
  return March(ray, inside, BlendBegin());
}
