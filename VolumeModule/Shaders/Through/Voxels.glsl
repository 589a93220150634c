#include "Math/LatticeWalk.glsl"
// Voxels without interpolation, as in March/MaterialVoxels.glsl: a ray goes from face to face, and
// its depth is exact.

float DepthAlong(Ray ray, Interval inside, ShadowMarch march)
{
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid + 0.5, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, voxelCount);
  float depth = 0.0;
  for (int index = 0; index < mostSegments && place.t < inside.exit && depth < march.mostDepth;
       ++index)
  {
    float visibleFrom = NextOfField(ray, inside, place.t, 0.0).enter;
    if (visibleFrom > place.t)
    {
      place = PlaceAt(lattice, visibleFrom, voxelCount);
    }
    LatticePlace behind = BehindCell(lattice, place);
    vec3 middleTexture = (place.cell + 0.5) / voxelCount;
    Values values = ValuesAt(middleTexture);
    float lengthMm = min(behind.t, inside.exit) - place.t;
    if (lengthMm > 0.0 && MayAbsorb(values, values) && IsSeen(ray, place.t + 0.5 * lengthMm))
    {
      depth += MaterialExtinction(values, GradientsAt(middleTexture)) * lengthMm;
    }
    place = behind;
  }
  return depth;
}
