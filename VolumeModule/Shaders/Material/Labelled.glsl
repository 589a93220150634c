#include "Math/Absorption.glsl"
#include "Math/Extinction.glsl"
#include "Math/LabelMixture.glsl"
// One scalar, seen through the transfer functions of the label at its place. If the label counts in
// part only, colors and opacities over a unit distance are mixed with those without a label.

vec4 LookOf(Values values, Gradients gradients)
{
  vec4 optical = OfRow(labelRow, values, gradients);
  if (labelPart < 1.0 && labelRow > 0)
  {
    vec4 plain = OfRow(0, values, gradients);
    optical = vec4(mix(plain.rgb, optical.rgb, labelPart),
      MixedExtinction(plain.a, optical.a, labelPart, opacityUnitDistancesMm.x));
  }
  return optical;
}

float MaterialExtinction(Values values, Gradients gradients)
{
  return LookOf(values, gradients).a;
}

vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t)
{
  vec4 optical = LookOf(values, gradients);
  return vec4(kept.x * LitLabel(optical.rgb, gradients.scalar, ray, t), optical.a);
}
