// What has no value is a homogeneous material of its own, not lit: it has no surface.

Accumulation FillGap(Accumulation sum, float lengthMm)
{
  return BlendPart(sum, gapOptical.rgb, gapOptical.a * lengthMm);
}
