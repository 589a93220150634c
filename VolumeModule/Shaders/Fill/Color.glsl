// What has no value is a homogeneous material of its own, not lit: it has no surface.

uniform vec4 gapOptical; // colour, not premultiplied, and extinction [1/mm]

Accumulation FillGap(Accumulation sum, float lengthMm)
{
  return BlendPart(sum, gapOptical.rgb, gapOptical.a * lengthMm);
}
