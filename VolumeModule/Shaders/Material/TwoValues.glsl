// Two scalars, seen through a transfer function of both. Light is that on the first.

uniform vec2 visibleScalars; // only between these does anything absorb, whatever the second is
uniform vec4 reflectance;
uniform vec2 placeFromScalar; // scale and bias: texture value -> [0,1] in its range
uniform vec2 placeFromSecond;

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
  return max(start.scalars.x, end.scalars.x) > visibleScalars.x &&
    min(start.scalars.x, end.scalars.x) < visibleScalars.y;
}

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec4 optical = ClassifyTwo(vec2(values.scalars.x * placeFromScalar.x + placeFromScalar.y,
    values.scalars.y * placeFromSecond.x + placeFromSecond.y));
  return vec4(Shade(optical.rgb, gradients.scalar, reflectance, ray, t), optical.a);
}
