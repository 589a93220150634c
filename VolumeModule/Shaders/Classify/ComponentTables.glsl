#include "Math/Tables.glsl"
// Transfer functions as tables of (r, g, b, extinction), one after the other in one buffer.

vec4 ClassifyBy(int table, float scalar)
{
  float last = lastTableIndices[table];
  float index = TableIndex(scalar, tableScales[table], tableBiases[table], last);
  float below = EntryBelow(index, last);
  int entry = int(firstEntries[table]) + int(below);
  return mix(texelFetch(opticalTable, entry), texelFetch(opticalTable, entry + 1), index - below);
}
