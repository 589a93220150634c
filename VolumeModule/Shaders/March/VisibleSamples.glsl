// The loop for samples that are dear to blend, as shaded ones are with the six fetches of their
// gradient: an inner loop looks for the next sample that absorbs anything. A branch would not do:
// where pixels are drawn in lockstep both of its sides are paid for, while a loop ends for all of
// them when it has ended for each.

Accumulation March(Ray ray, Interval inside)
{
  Accumulation sum = BlendBegin();
  float t = inside.enter;
  int index = 0;
  while (index < mostSegments && t < inside.exit && !BlendFinished(sum))
  {
    float middle;
    float lengthMm;
    float scalar;
    do
    {
      Interval segment = NextSegment(ray, inside, t, index, stepMm, BlendVisibility(sum));
      t = min(segment.exit, inside.exit);
      lengthMm = max(t - segment.enter, 0.0);
      middle = segment.enter + 0.5 * lengthMm;
      scalar = ScalarAt(PositionTexture(ray, middle));
      ++index;
    } while (!(Classify(scalar).a * lengthMm > 0.0) && t < inside.exit && index < mostSegments);
    sum = BlendPart(sum, ray, middle, lengthMm, scalar);
  }
  return sum;
}
