#include "Math/LatticeWalk.glsl"
// Voxels without interpolation, as in March/MaterialVoxels.glsl: a ray goes from face to face, and
// its depth is exact.

LatticeRay RayInVoxels(Ray ray)
{
  return RayInLattice(ray.originGrid - firstVoxelGrid + 0.5, ray.directionGrid);
}

// The optical depth of the voxel that a ray is in.
float VoxelDepth(Ray ray, LatticePlace place, float exit)
{
  vec3 middleTexture = (place.cell + 0.5) / voxelCount;
  Values values = ValuesAt(middleTexture);
  float lengthMm = exit - place.t;
  float depth = 0.0;
  if (lengthMm > 0.0 && MayAbsorb(values, values) && IsSeen(ray, place.t + 0.5 * lengthMm))
  {
    depth = MaterialExtinction(values, GradientsAt(middleTexture)) * lengthMm;
  }
  return depth;
}

float DepthAlong(Ray ray, Interval inside, ShadowMarch march)
{
  LatticeRay lattice = RayInVoxels(ray);
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
    depth += VoxelDepth(ray, place, min(behind.t, inside.exit));
    place = behind;
  }
  return depth;
}

float DepthNear(Ray ray, Interval inside, ShadowMarch march)
{
  LatticeRay lattice = RayInVoxels(ray);
  LatticePlace place = PlaceAt(lattice, inside.enter, voxelCount);
  float depth = 0.0;
  for (int index = 0; index < mostSegments && place.t < inside.exit && depth < march.mostDepth;
       ++index)
  {
    LatticePlace second = BehindCell(lattice, place);
    LatticePlace third = BehindCell(lattice, second);
    LatticePlace behind = BehindCell(lattice, third);
    depth += VoxelDepth(ray, place, min(second.t, inside.exit));
    depth += VoxelDepth(ray, second, min(third.t, inside.exit));
    depth += VoxelDepth(ray, third, min(behind.t, inside.exit));
    place = behind;
  }
  return depth;
}
