// There is no mask.

Accumulation MarchMasked(Ray ray, Interval inside, Accumulation sum)
{
  return MarchVolume(ray, inside, sum);
}
