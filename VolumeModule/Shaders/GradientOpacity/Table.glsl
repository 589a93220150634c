// The opacity over a unit distance is multiplied by a function of the gradient's magnitude, as VTK
// defines it: central differences in units of the data per mean spacing of the voxels. The table
// holds the factors of up to four components, from magnitude 0 to a quarter of the component's
// range; beyond that the last entry holds.

float AtGradient(float extinction, vec3 gradient, int component)
{
  float magnitude = length(spacingFactors * gradient);
  float index = min(magnitude * entriesPerGradient[component], lastGradientEntry);
  float below = min(floor(index), lastGradientEntry - 1.0);
  float a = texelFetch(gradientOpacityTable, int(below))[component];
  float b = texelFetch(gradientOpacityTable, int(below) + 1)[component];
  return WithOpacityFactor(extinction, opacityUnitDistancesMm[component], mix(a, b, index - below));
}
