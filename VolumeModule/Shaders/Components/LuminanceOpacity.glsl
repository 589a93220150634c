// Two components of one material: the first determines its colour, the second its opacity.

vec4 PartOptical(vec4 texel, int part)
{
  return vec4(ClassifyBy(0, texel.x).rgb, ClassifyBy(1, texel.y).a);
}

int OpacityComponent(int part)
{
  return 1;
}

vec4 MoreExtreme(vec4 best, vec4 texel, float sense)
{
  return sense * texel.y > sense * best.y ? texel : best;
}
