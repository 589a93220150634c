// Transfer functions as tables of (r, g, b, extinction), one after the other in one buffer.

vec4 ClassifyBy(int table, float scalar)
{
  float last = lastTableIndices[table];
  float index = clamp(scalar * tableScales[table] + tableBiases[table], 0.0, last);
  float below = min(floor(index), last - 1.0);
  int entry = int(firstEntries[table]) + int(below);
  return mix(texelFetch(opticalTable, entry), texelFetch(opticalTable, entry + 1), index - below);
}
