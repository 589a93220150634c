// The midpoint rule of Midpoint.glsl, from the back to the front.

const float StepsPerSegment = 4.0;

Accumulation OneOver(Accumulation behind, float scalar, float partMm)
{
  vec4 optical = Classify(scalar);
  return BlendOver(behind, optical.rgb, optical.a * partMm);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float segmentMm = StepsPerSegment * stepMm;
  Accumulation behind = BlendBegin();
  for (int index = SegmentCount(inside, segmentMm) - 1; index >= 0; --index)
  {
    Interval segment = SegmentOf(ray, inside, index, segmentMm);
    float partMm = (segment.exit - segment.enter) / StepsPerSegment;
    vec4 scalars = ScalarsOfFour(ray, segment.enter + 0.5 * partMm, partMm);
    behind = OneOver(behind, scalars.w, partMm);
    behind = OneOver(behind, scalars.z, partMm);
    behind = OneOver(behind, scalars.y, partMm);
    behind = OneOver(behind, scalars.x, partMm);
  }
  return BlendBehind(sum, behind);
}
