#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Isosurfaces of voxels without interpolation (see Voxels.glsl): the faces between voxels of at
// least the isovalue and voxels of less.

float CellsBeforeFirstVoxel()
{
  return 0.5;
}

vec3 CellCount()
{
  return voxelCount;
}

float scalarBefore; // value of the voxel that the ray has left

const float RoundingVoxels = 1e-4; // error of a place along a ray

void BeginCells(Ray ray)
{
  // Rounding may put the ray into the voxel before its beginning, which may be a gap.
  LatticePlace behind = BehindCell(cellRay, cell);
  bool begins = (behind.t - cell.t) * length(ray.directionGrid) > RoundingVoxels;
  cell.cell = begins ? cell.cell : behind.cell;
  scalarBefore = ScalarAt((cell.cell + 0.5) / voxelCount);
}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  while (cell.t < end)
  {
    vec3 middleTexture = (cell.cell + 0.5) / voxelCount;
    float scalar = ScalarAt(middleTexture);
    vec3 gradient = GradientAt(middleTexture);
    for (int i = 0; i < isosurfaceCount; ++i)
    {
      int surface = scalar > scalarBefore ? i : isosurfaceCount - 1 - i;
      if (IsPassed(surface, scalarBefore, scalar))
      {
        sum = BlendSurface(sum, surface, gradient, ray, cell.t);
      }
    }
    scalarBefore = scalar;
    cell = BehindCell(cellRay, cell);
  }
  return sum;
}
