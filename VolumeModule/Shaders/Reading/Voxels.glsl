#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// A volume without interpolation: its voxels are boxes of constant value, and segments end at their
// faces. The values and gradients of a segment are those in the middle of its voxel, and exact.

Values startValues;
Values endValues;
Gradients startGradients;
Gradients endGradients;
LatticeRay voxelRay;
LatticePlace voxel; // the voxel that the segment is in

void BeginReading(Ray ray, float t)
{
  voxelRay = RayInLattice(ray.originGrid - firstVoxelGrid + 0.5, ray.directionGrid);
  voxel = PlaceAt(voxelRay, t, voxelCount);
}

float NextReadingFace(float t)
{
  LatticePlace behind = BehindCell(voxelRay, voxel);
  if (behind.t < t)
  {
    voxel = PlaceAt(voxelRay, t, voxelCount);
    behind = BehindCell(voxelRay, voxel);
  }
  // A ray through an edge or a corner leaves several voxels at once.
  for (int i = 0; i < mostSegments && behind.t <= t; ++i)
  {
    voxel = behind;
    behind = BehindCell(voxelRay, voxel);
  }
  return behind.t;
}

void ReadValues(Ray ray, Interval segment)
{
  startValues = ValuesAt((voxel.cell + 0.5) / voxelCount);
  endValues = startValues;
}

vec4 KeptIn(Ray ray, Interval segment)
{
  return KeptOf(startValues, startGradients, voxel.cell + firstVoxelGrid);
}

void ReadGradients(Ray ray, Interval segment, bool isNext)
{
  startGradients = GradientsAt((voxel.cell + 0.5) / voxelCount);
  endGradients = startGradients;
}
