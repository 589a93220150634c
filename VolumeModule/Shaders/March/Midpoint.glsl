// Midpoint rule: a segment is cut into equal parts, each homogeneous as its middle is. Order 2.
// Eight parts, so that the look-up of a segment's length is paid an eighth as often; with more,
// what is marched beyond the end of a brick outweighs it.

const int PartsPerSegment = 8;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, float(PartsPerSegment) * stepMm, BlendState(sum));
    t = min(segment.exit, inside.exit);
    float partMm = max(t - segment.enter, 0.0) / float(PartsPerSegment);
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      float middle = segment.enter + (float(part) + 0.5) * partMm;
      vec4 optical = Classify(ScalarAt(PositionTexture(ray, middle)));
      sum = BlendPart(sum, optical.rgb, optical.a * partMm);
    }
  }
  return sum;
}
