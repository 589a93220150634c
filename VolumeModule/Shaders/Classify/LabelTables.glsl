#include "Math/Tables.glsl"
// Transfer functions as tables of (r, g, b, extinction), one after the other in one buffer. The
// buffer begins with one entry for each table: scale and bias from a scalar to an index, the first
// entry, and the last index.

vec4 ClassifyBy(int table, float scalar)
{
  vec4 row = texelFetch(opticalTable, table);
  float index = TableIndex(scalar, row.x, row.y, row.w);
  float below = EntryBelow(index, row.w);
  int entry = int(row.z) + int(below);
  return mix(texelFetch(opticalTable, entry), texelFetch(opticalTable, entry + 1), index - below);
}
