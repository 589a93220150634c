#include "Math/Planes.glsl"
// Clipping planes end the part of a ray that is marched exactly where it meets them.

bool IsClipped(vec3 positionGrid)
{
  bool clipped = false;
  for (int i = 0; i < clippingPlaneCount; ++i)
  {
    clipped = clipped || BeyondPlane(texelFetch(clippingPlanes, i), positionGrid) < 0.0;
  }
  return clipped;
}

Interval Clipped(Ray ray, Interval inside)
{
  vec2 kept = vec2(inside.enter, inside.exit);
  for (int i = 0; i < clippingPlaneCount; ++i)
  {
    vec4 plane = texelFetch(clippingPlanes, i);
    kept = CutByPlane(
      kept, BeyondPlane(plane, ray.originGrid), ApproachToPlane(plane, ray.directionGrid));
  }
  return Interval(kept.x, kept.y);
}
