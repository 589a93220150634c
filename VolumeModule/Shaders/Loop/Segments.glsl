// The loop along a ray from segment to segment. The rule of integration, a file of March, defines:

float StepsPerSegment(); // length of a segment in sample distances
// Adds a part from t on that Step skips, because it is invisible.
Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm);
// Adds a segment.
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
      break; // the rest of the ray is invisible
    }
    t = min(segment.exit, inside.exit);
    sum = TakeSegment(sum, ray, segment.enter, t - segment.enter);
  }
  return sum;
}
