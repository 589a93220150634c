// Four components of one material: the first three are its colour, the fourth determines its
// opacity.

vec4 PartOptical(vec4 texel, int part)
{
  return vec4(clamp(texel.rgb * colorScale + colorBias, 0.0, 1.0), ClassifyBy(0, texel.a).a);
}

int OpacityComponent(int part)
{
  return 3;
}

vec4 MoreExtreme(vec4 best, vec4 texel, float sense)
{
  return sense * texel.a > sense * best.a ? texel : best;
}
