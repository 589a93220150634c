#include "Math/HenyeyGreenstein.glsl"
// Matter scatters a part of the light, once, and surfaces reflect the rest.

vec2 SentToEye(vec2 reflected, float litPart, vec3 toLight, vec3 toEye, float reaching)
{
  float bySurfaces = (1.0 - scatteredPart) * litPart * ReachingSurfaces(reaching);
  float phase = HenyeyGreenstein(-dot(toLight, toEye), anisotropy);
  return bySurfaces * reflected + vec2(scatteredPart * phase * reaching, 0.0);
}

float PartOfSent(float litPart)
{
  return 1.0;
}
