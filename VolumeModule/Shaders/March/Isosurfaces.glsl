#include "Math/CellCubic.glsl"
#include "Math/CubicCrossing.glsl"
#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Isosurfaces of interpolated voxels. In a cell the scalar is a cubic along the ray, known from
// four samples. It is divided at its extremes, so that no surface is missed, however thin the
// region that it encloses. Neighbouring cells share the sample at their common face, so that no
// surface is crossed twice.

// The cells before the first voxel and behind the last one, 0 and voxelCount, are marched too.
float CellsBeforeFirstVoxel()
{
  return 1.0;
}

vec3 CellCount()
{
  return voxelCount + 1.0;
}

vec4 ScalarsOfCell(Ray ray, Interval part)
{
  return vec4(ScalarAt(PositionTexture(ray, part.enter)),
    ScalarAt(PositionTexture(ray, mix(part.enter, part.exit, 1.0 / 3.0))),
    ScalarAt(PositionTexture(ray, mix(part.enter, part.exit, 2.0 / 3.0))),
    ScalarAt(PositionTexture(ray, part.exit)));
}

bool MayHoldSurface(vec4 cubic)
{
  float lower = min(min(cubic.x, cubic.y), min(cubic.z, cubic.w));
  float upper = max(max(cubic.x, cubic.y), max(cubic.z, cubic.w));
  bool holds = false;
  for (int surface = 0; surface < isosurfaceCount; ++surface)
  {
    holds = holds || IsPassed(surface, lower, upper);
  }
  return holds;
}

// Adds the surfaces that the ray crosses in one piece of a part. The cubic is monotone in the
// piece.
Accumulation BlendMonotone(Accumulation sum, vec4 cubic, vec2 piece, Ray ray, Interval part)
{
  float first = CubicValue(cubic, piece.x);
  float last = CubicValue(cubic, piece.y);
  for (int i = 0; i < isosurfaceCount; ++i)
  {
    int surface = last > first ? i : isosurfaceCount - 1 - i;
    if (IsPassed(surface, first, last))
    {
      float t = mix(part.enter, part.exit, CubicCrossing(cubic, IsovalueOf(surface), piece));
      sum = BlendSurface(sum, surface, GradientAt(PositionTexture(ray, t)), ray, t);
    }
  }
  return sum;
}

void BeginCells(Ray ray) {}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  while (cell.t < end && !BlendFinished(sum))
  {
    Interval part;
    vec4 cubic;
    do
    {
      part.enter = cell.t;
      cell = BehindCell(cellRay, cell);
      part.exit = min(cell.t, exit);
      cubic = CubicThrough(ScalarsOfCell(ray, part));
    } while (cell.t < end && !MayHoldSurface(cubic));

    vec2 extremes = CubicExtremes(cubic);
    sum = BlendMonotone(sum, cubic, vec2(0.0, extremes.x), ray, part);
    sum = BlendMonotone(sum, cubic, extremes, ray, part);
    sum = BlendMonotone(sum, cubic, vec2(extremes.y, 1.0), ray, part);
  }
  return sum;
}
