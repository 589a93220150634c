// One scalar, and its gradient.

uniform vec2 visibleScalars; // only between these does anything absorb, whatever else decides

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
  return max(start.scalar, end.scalar) > visibleScalars.x &&
    min(start.scalar, end.scalar) < visibleScalars.y;
}
