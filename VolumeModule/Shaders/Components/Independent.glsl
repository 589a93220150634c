// Each component is a material of its own.

vec4 PartOptical(vec4 texel, int part)
{
  return ClassifyBy(part, texel[part]);
}

int OpacityComponent(int part)
{
  return part;
}

vec4 MoreExtreme(vec4 best, vec4 texel, float sense)
{
  return sense * max(sense * best, sense * texel);
}
