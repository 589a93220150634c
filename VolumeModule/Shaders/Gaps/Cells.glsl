#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Cells that touch a voxel that is not finite are gaps: the march ends at their faces, fills them
// (slot Fill) and continues behind them. Blanked cells are left out in the same way, but not
// filled. The cells lie between voxels, or are the voxels themselves, drawn as boxes, half a voxel
// away. The texel of cell c is 0 for a gap, 255 for a blanked cell, and k + 1 if the cells c - k to
// c + k are neither (Core/Fields/GapField.h).

float GapTexel(vec3 cell)
{
  vec3 inside = clamp(cell, vec3(0.0), gapCellCount - 1.0);
  return floor(textureLod(gapTexture, (inside + 0.5) * gapCellCountInverse, 0.0).r * 255.0 + 0.5);
}

// Central differences read the neighbouring cells too.
bool HasGradient(vec3 positionTexture)
{
  vec3 cell = floor(positionTexture * voxelCount - 0.5 + gapShift);
  float least = GapTexel(cell);
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 side = vec3(axis == 0, axis == 1, axis == 2);
    least = min(least, min(GapTexel(cell + side), GapTexel(cell - side)));
  }
  return least > 0.5;
}

bool HasValue(vec3 positionTexture)
{
  float texel = GapTexel(floor(positionTexture * voxelCount - 0.5 + gapShift));
  return texel > 0.5 && texel < 254.5;
}

Accumulation MarchVolume(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid + gapShift, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, gapCellCount);
  while (place.t < inside.exit && !BlendFinished(sum))
  {
    // Consecutive blocks without gaps are joined into one march.
    Interval part = Interval(place.t, place.t);
    float texel = 1.0;
    bool gap = false;
    while (place.t < inside.exit && !gap)
    {
      texel = GapTexel(place.cell);
      gap = texel < 0.5 || texel > 254.5;
      place = BehindBlock(lattice, place, gap ? 0.0 : texel - 1.0);
      part.exit = gap ? part.exit : min(place.t, inside.exit);
    }
    if (part.enter < part.exit)
    {
      sum = March(ray, part, sum);
    }
    float gapMm = max(min(place.t, inside.exit) - part.exit, 0.0);
    sum = FillGap(sum, texel < 0.5 ? gapMm : 0.0);
  }
  return sum;
}
