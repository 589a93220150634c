// A gap is a homogeneous material of its own. It is not lit, because it has no surface.

Accumulation FillGap(Accumulation sum, float lengthMm)
{
  return BlendPart(sum, gapOptical.rgb, gapOptical.a * lengthMm);
}
