// Transfer function as a table of (r, g, b, extinction), interpolated in full float precision:
// a buffer texture has no filter, whose weights have but 8 bits on most hardware.

vec4 Classify(float scalar)
{
  float index = clamp(scalar * tableScales.x + tableBiases.x, 0.0, lastTableIndices.x);
  float below = min(floor(index), lastTableIndices.x - 1.0);
  vec4 a = texelFetch(opticalTable, int(below));
  vec4 b = texelFetch(opticalTable, int(below) + 1);
  return mix(a, b, index - below);
}
