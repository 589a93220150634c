// The plain loop: every sample is blended. A segment is cut into equal parts, each sampled at its
// middle: two, so that the look-up of a segment's length is paid half as often.

const int SamplesPerSegment = 2;

Accumulation March(Ray ray, Interval inside)
{
  Accumulation sum = BlendBegin();
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, float(SamplesPerSegment) * stepMm, BlendVisibility(sum));
    t = min(segment.exit, inside.exit);
    float partMm = max(t - segment.enter, 0.0) / float(SamplesPerSegment);
    for (int part = 0; part < SamplesPerSegment; ++part)
    {
      float middle = segment.enter + (float(part) + 0.5) * partMm;
      sum = BlendPart(sum, ray, partMm, ScalarAt(PositionTexture(ray, middle)), vec3(0.0));
    }
  }
  return sum;
}
