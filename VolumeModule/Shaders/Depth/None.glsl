// No opaque geometry: rays end where the volume does.

float DepthLimit(Ray ray)
{
  return 3.0e38;
}
