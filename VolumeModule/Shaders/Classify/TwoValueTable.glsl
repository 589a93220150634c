// Transfer function of two values as a table of (r, g, b, opacity over a unit distance), whose
// first and last entries on each axis are those of the ends of the values' ranges.

// @param place  of both values in their ranges, [0,1]
vec4 ClassifyTwo(vec2 place)
{
  vec2 index = clamp(place, 0.0, 1.0) * (twoValueTableSize - 1.0);
  vec2 below = min(floor(index), twoValueTableSize - 2.0);
  vec2 part = index - below;
  int entry = int(below.y * twoValueTableSize.x + below.x);
  int above = entry + int(twoValueTableSize.x);
  vec4 lower = mix(texelFetch(twoValueTable, entry), texelFetch(twoValueTable, entry + 1), part.x);
  vec4 upper = mix(texelFetch(twoValueTable, above), texelFetch(twoValueTable, above + 1), part.x);
  vec4 found = mix(lower, upper, part.y);
  // Of an opaque material.
  return vec4(found.rgb, WithOpacityFactor(1e30, opacityUnitDistancesMm.x, found.a));
}
