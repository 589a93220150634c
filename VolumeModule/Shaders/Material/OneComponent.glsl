// One scalar, seen through the transfer function, and lit.

uniform vec2 visibleScalars; // only between these does anything absorb
uniform vec4 reflectance;

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

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec4 optical = Classify(values.scalar);
  return vec4(Shade(optical.rgb, gradients.scalar, reflectance, ray, t),
    AtGradient(optical.a, gradients.scalar, 0));
}
