// The loop along a ray in segments, which the rule of integration in March takes in:

float StepsPerSegment();
// What the ray leaves out from t on is invisible.
Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm);
Accumulation TakeSegment(Accumulation sum, Ray ray, float enter, float lengthMm);

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, StepsPerSegment() * stepMm, BlendState(sum));
    sum = TakeLeftOut(sum, ray, t, min(segment.enter, inside.exit) - t);
    if (segment.enter >= inside.exit)
    {
      break; // all that is left is invisible
    }
    t = min(segment.exit, inside.exit);
    sum = TakeSegment(sum, ray, segment.enter, t - segment.enter);
  }
  return sum;
}
