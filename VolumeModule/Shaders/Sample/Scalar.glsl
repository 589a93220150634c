// A sample is one scalar.

Accumulation BlendSample(Accumulation sum, vec3 positionTexture, float lengthMm)
{
  return BlendScalar(sum, ScalarAt(positionTexture), lengthMm);
}
