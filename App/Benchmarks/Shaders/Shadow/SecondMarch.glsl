#include "Math/IntersectBox.glsl"
// A second march from each sample to a distant light, with samples in the middles of steps.

const float DarkDepth = 10.0; // less than a byte's step of the light passes
uniform float shadowStepMm;

float Arriving(Ray ray)
{
  float exit = IntersectBox(ray.originGrid, SafeInverse(toLightGrid), vec3(0.0), boxUpperGrid).y;
  float depth = 0.0;
  for (float t = 0.0; t < exit && depth < DarkDepth; t += shadowStepMm)
  {
    float lengthMm = min(shadowStepMm, exit - t);
    vec3 middle = ray.originGrid + (t + 0.5 * lengthMm) * toLightGrid;
    depth += Classify(ScalarAt(TextureOfGrid(middle))).a * lengthMm;
  }
  return exp(-depth);
}
