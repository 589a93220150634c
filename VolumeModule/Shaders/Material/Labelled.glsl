// One scalar, seen through the transfer functions of the label of its place: a part of them, the
// other through those without a label. Colours, and opacities over a unit distance, are mixed.

uniform vec2 visibleScalars; // only between these does anything absorb, whatever its label
uniform vec4 reflectance;
uniform float labelPart; // [0,1]
uniform float labelUnitDistanceMm;

int labelRow; // of the place; 0 for none

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

// Colour, and opacity over a unit distance.
vec4 OfRow(int row, Values values, Gradients gradients)
{
  vec4 optical = ClassifyBy(row, values.scalar);
  float extinction = AtGradient(optical.a, gradients.scalar, row);
  return vec4(optical.rgb, Absorption(min(extinction * labelUnitDistanceMm, 80.0)));
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
    extinction = WithOpacityFactor(1e30, labelUnitDistanceMm, min(mixed.a, 0.99999994));
  }
  return vec4(Shade(optical.rgb, gradients.scalar, reflectance, ray, t), extinction);
}
