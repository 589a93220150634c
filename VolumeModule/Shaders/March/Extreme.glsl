// A maximum or minimum: samples find the peak, and halving steps around the best of them climb it.
// So the steps need only be short enough to tell the highest peak from the others.

const int PartsPerSegment = 8;
const int Halvings = 8;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  float best = t;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, float(PartsPerSegment) * stepMm, BlendState(sum));
    t = min(segment.exit, inside.exit);
    float partMm = max(t - segment.enter, 0.0) / float(PartsPerSegment);
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      float middle = segment.enter + (float(part) + 0.5) * partMm;
      float before = BlendState(sum);
      sum = BlendScalar(sum, ScalarAt(PositionTexture(ray, middle)), partMm);
      best = BlendState(sum) != before ? middle : best;
    }
  }

  float reach = stepMm;
  for (int halving = 0; halving < Halvings; ++halving)
  {
    reach *= 0.5;
    float center = best;
    for (int side = -1; side <= 1; side += 2)
    {
      float beside = clamp(center + float(side) * reach, inside.enter, inside.exit);
      float before = BlendState(sum);
      sum = BlendScalar(sum, ScalarAt(PositionTexture(ray, beside)), 0.0);
      best = BlendState(sum) != before ? beside : best;
    }
  }
  return sum;
}
