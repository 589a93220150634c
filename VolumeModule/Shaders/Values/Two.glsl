// Two scalars, and the gradient of the first.

struct Values
{
  vec2 scalars;
};

struct Gradients
{
  vec3 scalar;
};

Values ValuesAt(vec3 positionTexture)
{
  return Values(TexelAt(positionTexture).rg);
}

Gradients GradientsAt(vec3 positionTexture)
{
  return Gradients(GradientAt(positionTexture));
}

Values Between(Values start, Values end, float along)
{
  return Values(mix(start.scalars, end.scalars, along));
}

Gradients Between(Gradients start, Gradients end, float along)
{
  return Gradients(mix(start.scalar, end.scalar, along));
}

bool MayAbsorb(Values start, Values end)
{
  return max(start.scalars.x, end.scalars.x) > visibleLower.x &&
    min(start.scalars.x, end.scalars.x) < visibleUpper.x;
}

Values WithAdded(Values values, float scalar)
{
  return Values(values.scalars + vec2(scalar, 0.0));
}
