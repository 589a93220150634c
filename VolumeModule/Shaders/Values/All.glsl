// Up to four components, and the gradient of each.

struct Values
{
  vec4 scalars;
};

struct Gradients
{
  mat4x3 ofScalars;
};

Values ValuesAt(vec3 positionTexture)
{
  return Values(TexelAt(positionTexture));
}

Gradients GradientsAt(vec3 positionTexture)
{
  return Gradients(GradientsAllAt(positionTexture));
}

Values Between(Values start, Values end, float along)
{
  return Values(mix(start.scalars, end.scalars, along));
}

Gradients Between(Gradients start, Gradients end, float along)
{
  return Gradients(start.ofScalars + along * (end.ofScalars - start.ofScalars));
}

Values WithAdded(Values values, float scalar)
{
  return Values(values.scalars + scalar);
}

bool MayAbsorb(Values start, Values end)
{
  bool may = false;
  for (int component = 0; component < 4; ++component)
  {
    may = may ||
      (max(start.scalars[component], end.scalars[component]) > visibleLower[component] &&
        min(start.scalars[component], end.scalars[component]) < visibleUpper[component]);
  }
  return may;
}
