#include "Math/Absorption.glsl"
#include "Math/Extinction.glsl"
#include "Math/Gradients.glsl"
#include "Math/Tables.glsl"
// A table of factors for each label, as in Table.glsl. Four labels share the numbers of an entry.

float AtGradient(float extinction, vec3 gradient, int row)
{
  float index = GradientIndex(gradient, spacingFactors, entriesPerGradient.x, lastGradientEntry);
  float below = EntryBelow(index, lastGradientEntry);
  int entry = (row / 4) * int(lastGradientEntry + 1.0) + int(below);
  float a = texelFetch(gradientOpacityTable, entry)[row % 4];
  float b = texelFetch(gradientOpacityTable, entry + 1)[row % 4];
  return WithOpacityFactor(extinction, opacityUnitDistancesMm.x, mix(a, b, index - below));
}
