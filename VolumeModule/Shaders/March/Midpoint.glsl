// Midpoint rule: a segment is cut into equal parts, each homogeneous as its middle is. Order 2.
// Four parts, so that the look-up of a segment's length is paid a fourth as often; with more, what
// is marched beyond the end of a brick outweighs it.

const float PartsPerSegment = 4.0;

Accumulation BlendOne(Accumulation sum, float scalar, float partMm)
{
  vec4 optical = Classify(scalar);
  return BlendPart(sum, optical.rgb, optical.a * partMm);
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
    vec4 scalars = ScalarsOfFour(ray, segment.enter + 0.5 * partMm, partMm);
    sum = BlendOne(sum, scalars.x, partMm);
    sum = BlendOne(sum, scalars.y, partMm);
    sum = BlendOne(sum, scalars.z, partMm);
    sum = BlendOne(sum, scalars.w, partMm);
  }
  return sum;
}
