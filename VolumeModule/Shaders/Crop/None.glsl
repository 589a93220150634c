// The whole ray is drawn.

bool IsDrawn(Ray ray, float t)
{
  return true;
}

Accumulation MarchCropped(Ray ray, Interval inside, Accumulation sum)
{
  return MarchMasked(ray, inside, sum);
}
