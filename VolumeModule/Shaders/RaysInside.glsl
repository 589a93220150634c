#include "Math/IntersectBox.glsl"
// Rays that begin anywhere, for the files of Through and Around.

Ray RayFrom(vec3 originGrid, vec3 directionGrid)
{
  Ray ray;
  ray.originGrid = originGrid;
  ray.directionGrid = directionGrid;
  ray.originTexture = (originGrid - firstVoxelGrid + 0.5) * voxelCountInverse;
  ray.directionTexture = directionGrid * voxelCountInverse;
  return ray;
}

// The part of a ray from its origin on that lies in the volume's box.
Interval InOwnBox(Ray ray, float farMm)
{
  vec2 box =
    IntersectBox(ray.originGrid, SafeInverse(ray.directionGrid), ownLowerGrid, ownUpperGrid);
  return Interval(max(box.x, 0.0), min(box.y, farMm));
}

// The optical depth of a part of a ray, marched as its length asks for.
float DepthOf(Ray ray, Interval inside, ShadowMarch march)
{
  return march.isNear ? DepthNear(ray, inside, march) : DepthAlong(ray, inside, march);
}

// True if cropping, the mask and gaps leave the volume at t. Sets labelRow for it.
bool IsSeen(Ray ray, float t)
{
  labelRow = LabelRowAt(PositionGrid(ray, t));
  return labelRow >= 0 && IsDrawn(ray, t) && HasValue(PositionTexture(ray, t));
}
