// Transfer functions as tables of (r, g, b, extinction), one after the other in one buffer, which
// begins with a row for each: (scale and bias: texture value -> index; first entry; last index).

vec4 ClassifyBy(int table, float scalar)
{
  vec4 row = texelFetch(opticalTable, table);
  float index = clamp(scalar * row.x + row.y, 0.0, row.w);
  float below = min(floor(index), row.w - 1.0);
  int entry = int(row.z) + int(below);
  return mix(texelFetch(opticalTable, entry), texelFetch(opticalTable, entry + 1), index - below);
}
