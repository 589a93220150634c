// A maximum or minimum of interpolated voxels, exactly: in a cell the scalar is a cubic along the
// ray, known from four readings, which has its largest and smallest values at its ends or extremes.

// Cells before the first voxel and behind the last one are cells too: 0 and voxelCount.
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
    cell = BehindBlock(cellRay, cell, 0.0);
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
