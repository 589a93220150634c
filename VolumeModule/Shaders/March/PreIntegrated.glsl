// Pre-integrated rule: between two samples the scalar is taken as linear, and the transfer function
// is integrated exactly over what it takes: no peak is missed between two samples. Order 2.

const float PartsPerSegment = 8.0;

Accumulation BlendOne(Accumulation sum, float startScalar, float endScalar, float partMm)
{
  vec4 optical = ClassifyBetween(startScalar, endScalar);
  return BlendPart(sum, optical.rgb, optical.a * partMm);
}

Accumulation BlendFour(Accumulation sum, float startScalar, vec4 endScalars, float partMm)
{
  sum = BlendOne(sum, startScalar, endScalars.x, partMm);
  sum = BlendOne(sum, endScalars.x, endScalars.y, partMm);
  sum = BlendOne(sum, endScalars.y, endScalars.z, partMm);
  return BlendOne(sum, endScalars.z, endScalars.w, partMm);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, PartsPerSegment * stepMm, BlendState(sum));
    if (segment.enter >= inside.exit)
    {
      break; // all that is left is invisible
    }
    t = min(segment.exit, inside.exit);
    float partMm = (t - segment.enter) / PartsPerSegment;
    float startScalar = ScalarAt(PositionTexture(ray, segment.enter));
    vec4 firstHalf = ScalarsOfFour(ray, segment.enter + partMm, partMm);
    vec4 secondHalf = ScalarsOfFour(ray, segment.enter + 5.0 * partMm, partMm);
    sum = BlendFour(sum, startScalar, firstHalf, partMm);
    sum = BlendFour(sum, firstHalf.w, secondHalf, partMm);
  }
  return sum;
}
