// Pre-integrated rule: between two samples the scalar is linear, and the transfer function is
// integrated exactly over the values that it takes, so that no peak between samples is missed.
// Order 2.

float StepsPerSegment()
{
  return 8.0;
}

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

Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm)
{
  return sum;
}

Accumulation TakeSegment(Accumulation sum, Ray ray, float enter, float lengthMm)
{
  float partMm = lengthMm / StepsPerSegment();
  float startScalar = ScalarAt(PositionTexture(ray, enter));
  vec4 firstHalf = ScalarsOfFour(ray, enter + partMm, partMm);
  vec4 secondHalf = ScalarsOfFour(ray, enter + 5.0 * partMm, partMm);
  sum = BlendFour(sum, startScalar, firstHalf, partMm);
  return BlendFour(sum, firstHalf.w, secondHalf, partMm);
}
