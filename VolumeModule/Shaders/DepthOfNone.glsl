// Before the first of several volumes that take light from each other. DepthOfAll.glsl, behind the
// last of them, knows all.

float DepthOfAll(vec3 originWorld, vec3 directionWorld, ShadowMarch march);

float DepthOfVolumesBefore(vec3 originWorld, vec3 directionWorld, ShadowMarch march)
{
  return 0.0;
}
