// There is no mask.

int LabelRowAt(vec3 positionGrid)
{
  return 0;
}

Accumulation MarchMasked(Ray ray, Interval inside, Accumulation sum)
{
  return MarchVolume(ray, inside, sum);
}
