// Equal steps. Positions follow from the index, so that errors do not accumulate over thousands of
// steps.

Interval NextOfField(Ray ray, Interval inside, float t, float plainMm)
{
  return Interval(t, t + plainMm);
}

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  return Interval(t, inside.enter + (float(index) + FirstSegment()) * plainMm);
}
