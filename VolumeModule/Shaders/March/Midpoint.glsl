// Midpoint rule: a segment is cut into equal parts, each homogeneous as its middle is. Order 2.
// Four parts, so that the look-up of a segment's length is paid a fourth as often; with more, what
// is marched beyond the end of a brick outweighs it.

float StepsPerSegment()
{
  return 4.0;
}

Accumulation BlendOne(Accumulation sum, float scalar, float partMm)
{
  vec4 optical = Classify(scalar);
  return BlendPart(sum, optical.rgb, optical.a * partMm);
}

Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm)
{
  return sum;
}

Accumulation TakeSegment(Accumulation sum, Ray ray, float enter, float lengthMm)
{
  float partMm = lengthMm / StepsPerSegment();
  vec4 scalars = ScalarsOfFour(ray, enter + 0.5 * partMm, partMm);
  sum = BlendOne(sum, scalars.x, partMm);
  sum = BlendOne(sum, scalars.y, partMm);
  sum = BlendOne(sum, scalars.z, partMm);
  return BlendOne(sum, scalars.w, partMm);
}
