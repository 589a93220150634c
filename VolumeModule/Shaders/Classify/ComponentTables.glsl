// Transfer functions as tables of (r, g, b, extinction), one after the other in one buffer.

uniform samplerBuffer opticalTable;
uniform vec2 tablesFromScalar[4]; // scale and bias: texture value -> index in its table
uniform float firstEntries[4];
uniform float lastTableIndices[4];

vec4 ClassifyBy(int table, float scalar)
{
  vec2 indexFromScalar = tablesFromScalar[table];
  float last = lastTableIndices[table];
  float index = clamp(scalar * indexFromScalar.x + indexFromScalar.y, 0.0, last);
  float below = min(floor(index), last - 1.0);
  int entry = int(firstEntries[table]) + int(below);
  return mix(texelFetch(opticalTable, entry), texelFetch(opticalTable, entry + 1), index - below);
}
