#include "Math/CellCubic.glsl"
#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// The exact maximum or minimum of interpolated voxels. In a cell the scalar is a cubic along the
// ray, known from four samples; its largest and smallest values are at its ends or its extremes.

// The cells before the first voxel and behind the last one, 0 and voxelCount, are marched too.
float CellsBeforeFirstVoxel()
{
  return 1.0;
}

vec3 CellCount()
{
  return voxelCount + 1.0;
}

void BeginCells(Ray ray) {}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  vec4 scalars = vec4(ScalarAt(PositionTexture(ray, cell.t)));
  while (cell.t < end)
  {
    float enter = cell.t;
    cell = BehindCell(cellRay, cell);
    float leave = min(cell.t, exit);
    scalars = vec4(scalars.w, ScalarAt(PositionTexture(ray, mix(enter, leave, 1.0 / 3.0))),
      ScalarAt(PositionTexture(ray, mix(enter, leave, 2.0 / 3.0))),
      ScalarAt(PositionTexture(ray, leave)));
    vec4 cubic = CubicThrough(scalars);
    vec2 extremes = CubicExtremes(cubic);
    sum = BlendScalar(sum, cubic.x, 0.0);
    sum = BlendScalar(sum, CubicValue(cubic, extremes.x), 0.0);
    sum = BlendScalar(sum, CubicValue(cubic, extremes.y), 0.0);
    sum = BlendScalar(sum, cubic.w, 0.0);
  }
  return sum;
}
