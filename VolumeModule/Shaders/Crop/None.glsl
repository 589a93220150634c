// The whole ray is drawn.

Accumulation MarchCropped(Ray ray, Interval inside, Accumulation sum)
{
  return MarchMasked(ray, inside, sum);
}
