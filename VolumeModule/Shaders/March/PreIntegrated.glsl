// Pre-integrated rule: between two samples the scalar is taken as linear, and the transfer function
// is integrated exactly over what it takes: no peak is missed between two samples. Order 2.

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
    float startScalar = ScalarAt(PositionTexture(ray, segment.enter));
    for (int part = 1; part <= PartsPerSegment; ++part)
    {
      float endScalar = ScalarAt(PositionTexture(ray, segment.enter + float(part) * partMm));
      vec4 optical = ClassifyBetween(startScalar, endScalar);
      sum = BlendPart(sum, optical.rgb, optical.a * partMm);
      startScalar = endScalar;
    }
  }
  return sum;
}
