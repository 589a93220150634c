// Steps of the sample distance, longer behind what is nearly opaque: for volumes of which the
// optical field has found that hardly a brick could be skipped.

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  return Interval(t, t + StepGrowth(blendState) * PlainMm(index, plainMm));
}
