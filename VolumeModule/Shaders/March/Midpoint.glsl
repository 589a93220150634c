// Midpoint rule: a segment is cut into equal parts, each homogeneous as its middle is. Order 2.
// Eight parts, so that the look-up of a segment's length is paid an eighth as often; with more,
// what is marched beyond the end of a brick outweighs it.

const float PartsPerSegment = 8.0;

Accumulation BlendOne(Accumulation sum, float scalar, float partMm)
{
  vec4 optical = Classify(scalar);
  return BlendPart(sum, optical.rgb, optical.a * partMm);
}

Accumulation BlendFour(Accumulation sum, vec4 scalars, float partMm)
{
  sum = BlendOne(sum, scalars.x, partMm);
  sum = BlendOne(sum, scalars.y, partMm);
  sum = BlendOne(sum, scalars.z, partMm);
  return BlendOne(sum, scalars.w, partMm);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, PartsPerSegment * stepMm, BlendState(sum));
    t = min(segment.exit, inside.exit);
    float partMm = max(t - segment.enter, 0.0) / PartsPerSegment;
    vec4 firstHalf = ScalarsOfFour(ray, segment.enter + 0.5 * partMm, partMm);
    vec4 secondHalf = ScalarsOfFour(ray, segment.enter + 4.5 * partMm, partMm);
    sum = BlendFour(sum, firstHalf, partMm);
    sum = BlendFour(sum, secondHalf, partMm);
  }
  return sum;
}
