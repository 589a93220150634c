// Surfaces receive all light.

float LitPart(vec3 gradient)
{
  return 1.0;
}
