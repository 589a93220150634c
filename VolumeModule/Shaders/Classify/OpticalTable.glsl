#include "Math/Tables.glsl"
// A transfer function as a table of (r, g, b, extinction), interpolated in full float precision:
// filters of textures have weights of only 8 bits on most hardware, so this is a buffer texture.

vec4 Classify(float scalar)
{
  float index = TableIndex(scalar, tableScales.x, tableBiases.x, lastTableIndices.x);
  float below = EntryBelow(index, lastTableIndices.x);
  vec4 a = texelFetch(opticalTable, int(below));
  vec4 b = texelFetch(opticalTable, int(below) + 1);
  return mix(a, b, index - below);
}
