// Transfer function as a table of (r, g, b, extinction), interpolated in full float precision:
// a buffer texture has no filter, whose weights have but 8 bits on most hardware.

uniform samplerBuffer opticalTable;
uniform vec2 tableFromScalar; // scale and bias: texture value -> table index
uniform float lastTableIndex;

vec4 Classify(float scalar)
{
  float index = clamp(scalar * tableFromScalar.x + tableFromScalar.y, 0.0, lastTableIndex);
  float below = min(floor(index), lastTableIndex - 1.0);
  vec4 a = texelFetch(opticalTable, int(below));
  vec4 b = texelFetch(opticalTable, int(below) + 1);
  return mix(a, b, index - below);
}
