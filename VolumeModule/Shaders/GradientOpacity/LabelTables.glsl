// As with one table, for the label of a place: four labels share the numbers of an entry.

uniform samplerBuffer gradientOpacityTable;
uniform float lastGradientEntry; // of each table
uniform vec3 spacingFactors;     // mean spacing over twice the spacing along each axis
uniform vec4 entriesPerGradient; // gradient in texels -> table index
uniform vec4 opacityUnitDistancesMm;

float AtGradient(float extinction, vec3 gradient, int row)
{
  float magnitude = length(spacingFactors * gradient);
  float index = min(magnitude * entriesPerGradient.x, lastGradientEntry);
  float below = min(floor(index), lastGradientEntry - 1.0);
  int entry = (row / 4) * int(lastGradientEntry + 1.0) + int(below);
  float a = texelFetch(gradientOpacityTable, entry)[row % 4];
  float b = texelFetch(gradientOpacityTable, entry + 1)[row % 4];
  return WithOpacityFactor(extinction, opacityUnitDistancesMm.x, mix(a, b, index - below));
}
