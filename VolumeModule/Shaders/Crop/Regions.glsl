#include "Math/Planes.glsl"
// Cropping by regions: six planes divide a ray into pieces, each of which lies in one region.

float NextCrossing(Ray ray, float t, float exit)
{
  float next = exit;
  for (int i = 0; i < 6; ++i)
  {
    float approach = ApproachToPlane(croppingPlanes[i], ray.directionGrid);
    float crossing = -BeyondPlane(croppingPlanes[i], ray.originGrid) / approach;
    next = approach != 0.0 && crossing > t ? min(next, crossing) : next;
  }
  return next;
}

int PlanesBelow(vec3 position, int axis)
{
  return int(BeyondPlane(croppingPlanes[2 * axis], position) >= 0.0) +
    int(BeyondPlane(croppingPlanes[2 * axis + 1], position) >= 0.0);
}

bool IsDrawn(Ray ray, float t)
{
  vec3 position = PositionGrid(ray, t);
  int region =
    PlanesBelow(position, 0) + 3 * PlanesBelow(position, 1) + 9 * PlanesBelow(position, 2);
  return (croppingRegions >> region & 1) != 0;
}

Accumulation MarchCropped(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  while (t < inside.exit && !BlendFinished(sum))
  {
    // Consecutive pieces that are drawn are joined into one march.
    Interval part = Interval(t, t);
    bool drawn = true;
    while (t < inside.exit && drawn)
    {
      float next = NextCrossing(ray, t, inside.exit);
      drawn = IsDrawn(ray, 0.5 * (t + next));
      part.exit = drawn ? next : part.exit;
      t = next;
    }
    if (part.enter < part.exit)
    {
      sum = MarchMasked(ray, part, sum);
    }
  }
  return sum;
}
