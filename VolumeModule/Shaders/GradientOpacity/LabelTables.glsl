// As with one table, for the label of a place: four labels share the numbers of an entry.

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
