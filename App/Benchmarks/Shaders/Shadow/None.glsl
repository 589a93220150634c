// All light reaches every sample.

float Arriving(Ray ray)
{
  return 1.0;
}
