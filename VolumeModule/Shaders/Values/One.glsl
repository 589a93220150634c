// One scalar and its gradient.

struct Values
{
  float scalar;
};

struct Gradients
{
  vec3 scalar;
};

Values ValuesAt(vec3 positionTexture)
{
  return Values(ScalarAt(positionTexture));
}

Gradients GradientsAt(vec3 positionTexture)
{
  return Gradients(GradientAt(positionTexture));
}

Values Between(Values start, Values end, float along)
{
  return Values(mix(start.scalar, end.scalar, along));
}

Gradients Between(Gradients start, Gradients end, float along)
{
  return Gradients(mix(start.scalar, end.scalar, along));
}

bool MayAbsorb(Values start, Values end)
{
  return max(start.scalar, end.scalar) > visibleLower.x &&
    min(start.scalar, end.scalar) < visibleUpper.x;
}

Values WithAdded(Values values, float scalar)
{
  return Values(values.scalar + scalar);
}
