#include "Math/IntersectBox.glsl"
// A ray from each sample to a distant light as VTK marches it from version 9.2 on: it begins a step
// away from the sample, samples are at the beginnings of steps, steps are as long in the texture as
// those of the eye's ray, each counts as one in the world, and all of them are taken.

uniform float shadowStepMm;

float Arriving(Ray ray)
{
  float stepTexture = length(ray.directionTexture) * shadowStepMm;
  vec3 toLightTexture = normalize(toLightGrid * voxelCountInverse);
  vec3 origin = ray.originTexture + stepTexture * toLightTexture;
  float exit = IntersectBox(origin, SafeInverse(toLightTexture), vec3(0.0), vec3(1.0)).y;
  float arriving = 1.0;
  if (exit < stepTexture)
  {
    return arriving;
  }
  for (float t = 0.0; t < exit; t += stepTexture)
  {
    float extinction = Classify(ScalarAt(origin + t * toLightTexture)).a;
    arriving *= 1.0 - Absorbed(extinction, shadowStepMm);
  }
  return arriving;
}
