#include "Math/StepGrowth.glsl"
// Steps of the sample distance, and longer ones behind nearly opaque parts. It is for volumes of
// which hardly a brick can be skipped, according to the optical field.

Interval NextOfField(Ray ray, Interval inside, float t, float plainMm)
{
  return Interval(t, t + plainMm);
}

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  return NextOfField(ray, inside, t, StepGrowth(blendState) * PlainMm(index, plainMm));
}
