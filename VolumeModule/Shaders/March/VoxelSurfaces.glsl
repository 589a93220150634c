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

void BeginCells(Ray ray)
{
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
