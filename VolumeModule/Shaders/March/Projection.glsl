// Projections, which depend on values only. A part of the ray that Step leaves out is sampled once,
// at its beginning: it is invisible, but its length counts.

float StepsPerSegment()
{
  return 4.0;
}

Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm)
{
  return BlendSample(sum, PositionTexture(ray, t), lengthMm);
}

Accumulation TakeSegment(Accumulation sum, Ray ray, float enter, float lengthMm)
{
  float partMm = lengthMm / StepsPerSegment();
  for (int part = 0; part < int(StepsPerSegment()); ++part)
  {
    float middle = enter + (float(part) + 0.5) * partMm;
    sum = BlendSample(sum, PositionTexture(ray, middle), partMm);
  }
  return sum;
}
