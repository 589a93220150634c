// Equal steps. Positions come from the index, so that nothing accumulates over thousands of steps.

const int SamplesPerSegment = 1;

uniform float stepMm;

Interval NextSegment(Ray ray, Interval inside, float t, int index)
{
  return Interval(t, inside.enter + float(index + 1) * stepMm);
}
