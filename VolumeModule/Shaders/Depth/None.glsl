// There is no opaque geometry: rays end where the volume ends.

float DepthLimit(Ray ray)
{
  return 3.0e38;
}

float Trust(Ray ray, Interval inside, ivec2 coarsePixel)
{
  return 1.0;
}
