#include "Math/Absorption.glsl"
#include "Math/Extinction.glsl"
#include "Math/Tables.glsl"
// A transfer function of two values as a table of (r, g, b, opacity over a unit distance). Its
// first and last entries on each axis are those of the ends of the values' ranges.

// @param place  both values in their ranges, [0, 1]
vec4 ClassifyTwo(vec2 place)
{
  vec2 last = twoValueTableSize - 1.0;
  float x = TableIndex(place.x, last.x, 0.0, last.x);
  float y = TableIndex(place.y, last.y, 0.0, last.y);
  vec2 below = vec2(EntryBelow(x, last.x), EntryBelow(y, last.y));
  vec2 part = vec2(x, y) - below;
  int entry = int(below.y * twoValueTableSize.x + below.x);
  int above = entry + int(twoValueTableSize.x);
  vec4 lower = mix(texelFetch(twoValueTable, entry), texelFetch(twoValueTable, entry + 1), part.x);
  vec4 upper = mix(texelFetch(twoValueTable, above), texelFetch(twoValueTable, above + 1), part.x);
  vec4 found = mix(lower, upper, part.y);
  return vec4(found.rgb, ExtinctionOf(found.a, opacityUnitDistancesMm.x));
}
