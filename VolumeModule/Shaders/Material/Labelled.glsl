// One scalar, seen through the transfer functions of the label of its place: a part of them, the
// other through those without a label. Colours, and opacities over a unit distance, are mixed.

// Colour, and opacity over a unit distance.
vec4 OfRow(int row, Values values, Gradients gradients)
{
  vec4 optical = ClassifyBy(row, values.scalar);
  float extinction = AtGradient(optical.a, gradients.scalar, row);
  return vec4(optical.rgb, Absorption(min(extinction * opacityUnitDistancesMm.x, 80.0)));
}

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec4 optical = ClassifyBy(labelRow, values.scalar);
  float extinction = AtGradient(optical.a, gradients.scalar, labelRow);
  if (labelPart < 1.0 && labelRow > 0)
  {
    vec4 mixed = mix(OfRow(0, values, gradients), OfRow(labelRow, values, gradients), labelPart);
    optical.rgb = mixed.rgb;
    // Of an opaque material.
    extinction = WithOpacityFactor(1e30, opacityUnitDistancesMm.x, min(mixed.a, 0.99999994));
  }
  return vec4(Shade(optical.rgb, gradients.scalar, reflectances[0], ray, t), extinction);
}
