// All light from all around arrives everywhere.

float KeptOf(Values values, Gradients gradients, vec3 positionGrid)
{
  return 1.0;
}

float KeptAt(Ray ray, float t)
{
  return 1.0;
}
