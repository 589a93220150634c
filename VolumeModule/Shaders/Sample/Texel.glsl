// A sample is the values of several components.

Accumulation BlendSample(Accumulation sum, vec3 positionTexture, float lengthMm)
{
  return BlendTexel(sum, TexelAt(positionTexture), lengthMm);
}
