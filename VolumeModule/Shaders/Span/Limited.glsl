#include "Math/Span.glsl"
// Rays begin at a distance from the eye, which may be in the volume, and end after a number of
// steps. Steps count from where a ray enters the whole volume, of which only a block or the visible
// part may be marched.

Interval Spanned(Ray ray, Interval inside)
{
  vec3 toEye = worldFromGrid * (eyeGrid - ray.originGrid);
  float first = dot(toEye, worldFromGrid * ray.directionGrid) + firstDistanceMm;
  float enterWhole = InsideBox(ray, wholeLowerGrid, wholeUpperGrid).enter;
  vec2 spanned = CutToSpan(vec2(inside.enter, inside.exit), enterWhole, first, spanMm);
  return Interval(spanned.x, spanned.y);
}
