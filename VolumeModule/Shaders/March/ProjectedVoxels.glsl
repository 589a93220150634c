#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Projections of voxels without interpolation (see Voxels.glsl). A voxel that the ray only touches
// is left out, because rounding may put such a voxel at the beginning or the end of a ray.

// The length of the shortest part of a ray in a voxel that counts [voxels].
const float ShortestVoxels = 2e-5;
float CellsBeforeFirstVoxel()
{
  return 0.5;
}

vec3 CellCount()
{
  return voxelCount;
}

void BeginCells(Ray ray) {}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  while (cell.t < end)
  {
    LatticePlace behind = BehindCell(cellRay, cell);
    float lengthMm = min(behind.t, exit) - cell.t;
    Accumulation seen = BlendScalar(sum, ScalarAt((cell.cell + 0.5) / voxelCount), lengthMm);
    if (lengthMm * length(ray.directionGrid) > ShortestVoxels)
    {
      sum = seen;
    }
    cell = behind;
  }
  return sum;
}
