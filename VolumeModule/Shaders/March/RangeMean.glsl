#include "Math/CellCubic.glsl"
#include "Math/CubicCrossing.glsl"
#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// The mean of the values in a range. In a cell the scalar is a cubic along the ray, known from four
// samples. It is divided at its extremes and where it enters and leaves the range, so that no part
// that counts is missed, however short.

// The cells before the first voxel and behind the last one, 0 and voxelCount, are marched too.
float CellsBeforeFirstVoxel()
{
  return 1.0;
}

vec3 CellCount()
{
  return voxelCount + 1.0;
}

// Adds the part of a cell between two places in [0, 1], all of which counts.
Accumulation BlendCounted(Accumulation sum, vec4 cubic, float from, float to, float cellMm)
{
  float lengthMm = (to - from) * cellMm;
  int count = int(min(floor(lengthMm / stepMm), 1023.0)) + 1;
  for (int i = 0; i < count; ++i)
  {
    float scalar = CubicValue(cubic, mix(from, to, (float(i) + 0.5) / float(count)));
    sum =
      BlendScalar(sum, clamp(scalar, averagedLower.x, averagedUpper.x), lengthMm / float(count));
  }
  return sum;
}

// Adds what is in a range of one piece of a cell, in which the cubic is monotone.
Accumulation BlendMonotone(Accumulation sum, vec4 cubic, vec2 piece, vec2 range, float cellMm)
{
  float first = CubicValue(cubic, piece.x);
  float last = CubicValue(cubic, piece.y);
  float low = min(first, last);
  float high = max(first, last);
  if (high < range.x || low > range.y)
  {
    return sum;
  }
  float atLow = first <= last ? piece.x : piece.y;
  float atHigh = piece.x + piece.y - atLow;
  atLow = low < range.x ? CubicCrossing(cubic, range.x, piece) : atLow;
  atHigh = high > range.y ? CubicCrossing(cubic, range.y, piece) : atHigh;
  return BlendCounted(sum, cubic, min(atLow, atHigh), max(atLow, atHigh), cellMm);
}

Accumulation BlendCell(Accumulation sum, vec4 cubic, float cellMm)
{
  // A value at an end of the range counts, although the cubic rounds it.
  vec4 sizes = abs(cubic);
  float rounding = 1e-6 * max(max(sizes.x, sizes.y), max(sizes.z, sizes.w));
  vec2 range = vec2(averagedLower.x - rounding, averagedUpper.x + rounding);
  float low = min(min(cubic.x, cubic.y), min(cubic.z, cubic.w));
  float high = max(max(cubic.x, cubic.y), max(cubic.z, cubic.w));
  if (high < range.x || low > range.y)
  {
    return sum;
  }
  if (low >= range.x && high <= range.y)
  {
    return BlendCounted(sum, cubic, 0.0, 1.0, cellMm);
  }
  vec2 extremes = CubicExtremes(cubic);
  sum = BlendMonotone(sum, cubic, vec2(0.0, extremes.x), range, cellMm);
  sum = BlendMonotone(sum, cubic, extremes, range, cellMm);
  return BlendMonotone(sum, cubic, vec2(extremes.y, 1.0), range, cellMm);
}

void BeginCells(Ray ray) {}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  float scalar = ScalarAt(PositionTexture(ray, cell.t));
  while (cell.t < end)
  {
    float enter = cell.t;
    cell = BehindCell(cellRay, cell);
    float leave = min(cell.t, exit);
    vec4 scalars = vec4(scalar, ScalarAt(PositionTexture(ray, mix(enter, leave, 1.0 / 3.0))),
      ScalarAt(PositionTexture(ray, mix(enter, leave, 2.0 / 3.0))),
      ScalarAt(PositionTexture(ray, leave)));
    sum = BlendCell(sum, CubicThrough(scalars), leave - enter);
    scalar = scalars.w;
  }
  return sum;
}
