// Cells with a voxel that is not finite are filled with what is drawn there: the march ends at
// their faces and goes on behind them. The field's texel of cell c holds 0 where the cell is left
// out, else k + 1 where none of the cells c - k ... c + k is (the variation field of a tolerance
// without limit).

uniform sampler3D gapTexture; // nearest
uniform vec3 gapCellCount;
uniform vec3 gapCellCountInverse;
uniform vec3 gapVoxelCount;

float GapReach(vec3 cell)
{
  vec3 inside = clamp(cell, vec3(0.0), gapCellCount - 1.0);
  return floor(textureLod(gapTexture, (inside + 0.5) * gapCellCountInverse, 0.0).r * 255.0 + 0.5);
}

// Central differences read the cells beside.
bool HasGradient(vec3 positionTexture)
{
  vec3 cell = floor(positionTexture * gapVoxelCount - 0.5);
  float least = GapReach(cell);
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 side = vec3(axis == 0, axis == 1, axis == 2);
    least = min(least, min(GapReach(cell + side), GapReach(cell - side)));
  }
  return least > 0.5;
}

Accumulation MarchVolume(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, gapCellCount);
  while (place.t < inside.exit && !BlendFinished(sum))
  {
    // Blocks without a gap are joined to one march.
    Interval part = Interval(place.t, place.t);
    bool gap = false;
    while (place.t < inside.exit && !gap)
    {
      float reach = GapReach(place.cell);
      gap = reach < 0.5;
      place = BehindBlock(lattice, place, max(reach - 1.0, 0.0));
      part.exit = gap ? part.exit : min(place.t, inside.exit);
    }
    if (part.enter < part.exit)
    {
      sum = March(ray, part, sum);
    }
    sum = FillGap(sum, max(min(place.t, inside.exit) - part.exit, 0.0));
  }
  return sum;
}
