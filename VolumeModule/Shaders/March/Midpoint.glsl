// Midpoint rule: a segment is divided into equal parts, each homogeneous with the look of its
// middle. Order 2. With four parts the length of a segment is looked up a fourth as often as with
// one; with more, the samples beyond the end of a brick would cost more than that saves.

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
