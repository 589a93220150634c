// Surfaces reflect all light that arrives.

vec2 SentToEye(vec2 reflected, float litPart, vec3 toLight, vec3 toEye, float reaching)
{
  return reaching * reflected;
}

float PartOfSent(float litPart)
{
  return litPart;
}
