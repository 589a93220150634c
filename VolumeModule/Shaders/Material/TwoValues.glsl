// Two scalars, seen through a transfer function of both. The gradient of the first one is lit.

vec4 LookOf(Values values)
{
  return ClassifyTwo(vec2(values.scalars.x * placeFromScalar.x + placeFromScalar.y,
    values.scalars.y * placeFromSecond.x + placeFromSecond.y));
}

float MaterialExtinction(Values values, Gradients gradients)
{
  return LookOf(values).a;
}

vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t)
{
  vec4 optical = LookOf(values);
  return vec4(kept.x * Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t), optical.a);
}
