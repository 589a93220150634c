#include "Math/Absorption.glsl"
#include "Math/Extinction.glsl"
#include "Math/Gradients.glsl"
#include "Math/Tables.glsl"
// The opacity over a unit distance is multiplied by a function of the gradient's magnitude, as VTK
// defines it. The table holds the factors of up to four components, from magnitude 0 to a quarter
// of the component's range.

float AtGradient(float extinction, vec3 gradient, int component)
{
  float index =
    GradientIndex(gradient, spacingFactors, entriesPerGradient[component], lastGradientEntry);
  float below = EntryBelow(index, lastGradientEntry);
  float a = texelFetch(gradientOpacityTable, int(below))[component];
  float b = texelFetch(gradientOpacityTable, int(below) + 1)[component];
  return WithOpacityFactor(extinction, opacityUnitDistancesMm[component], mix(a, b, index - below));
}
