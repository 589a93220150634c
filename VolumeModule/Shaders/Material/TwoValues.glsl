// Two scalars, seen through a transfer function of both. The gradient of the first one is lit.

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec4 optical = ClassifyTwo(vec2(values.scalars.x * placeFromScalar.x + placeFromScalar.y,
    values.scalars.y * placeFromSecond.x + placeFromSecond.y));
  return vec4(Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t), optical.a);
}
