#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Voxels without interpolation: boxes of constant value, which extend half a voxel to every side. A
// ray goes from face to face and samples each voxel once, in its middle, so that the sum is exact.

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
    vec4 optical = Classify(ScalarAt((cell.cell + 0.5) / voxelCount));
    sum = BlendPart(sum, optical.rgb, optical.a * (min(behind.t, exit) - cell.t));
    cell = behind;
  }
  return sum;
}
