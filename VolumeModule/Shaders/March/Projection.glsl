// Projections look at nothing but values. What a ray leaves out is invisible throughout, as its
// first point is.

const int PartsPerSegment = 4;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, float(PartsPerSegment) * stepMm, BlendState(sum));
    float leftOutMm = min(segment.enter, inside.exit) - t;
    sum = BlendSample(sum, PositionTexture(ray, t), leftOutMm);
    if (segment.enter >= inside.exit)
    {
      break; // all that is left is invisible
    }
    t = min(segment.exit, inside.exit);
    float partMm = (t - segment.enter) / float(PartsPerSegment);
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      float middle = segment.enter + (float(part) + 0.5) * partMm;
      sum = BlendSample(sum, PositionTexture(ray, middle), partMm);
    }
  }
  return sum;
}
