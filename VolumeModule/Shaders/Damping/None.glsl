// Light as it is.

float LitPart(vec3 gradient)
{
  return 1.0;
}
