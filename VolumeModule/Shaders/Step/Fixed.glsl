// Equal steps. Positions come from the index, so that nothing accumulates over thousands of steps.

const int SamplesPerSegment = 1;

uniform float stepMm;

float SegmentEnd(Ray ray, Interval inside, float t, int index)
{
  return inside.enter + float(index + 1) * stepMm;
}
