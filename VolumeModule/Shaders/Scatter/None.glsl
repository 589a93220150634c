// Surfaces reflect all light that they receive.

vec2 SentToEye(vec2 reflected, float litPart, vec3 toLight, vec3 toEye, float reaching)
{
  return ReachingSurfaces(reaching) * reflected;
}

float PartOfSent(float litPart)
{
  return litPart;
}
