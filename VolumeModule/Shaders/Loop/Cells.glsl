#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// The loop along a ray from cell to cell of a lattice. Segments of a few cells let slot Step skip
// invisible parts. The file of March adds the cells, exactly, and defines:

vec3 CellCount();
float CellsBeforeFirstVoxel(); // number of cells up to the middle of the first voxel
void BeginCells(Ray ray);      // called when the ray is in its first cell
// Adds the cells from `cell` on, up to the one that the ray is in at `end` [mm]. The ray leaves the
// volume at `exit` [mm].
Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit);

LatticeRay cellRay;
LatticePlace cell; // the cell that the ray is in

const float CellsPerSegment = 4.0;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  cellRay =
    RayInLattice(ray.originGrid - firstVoxelGrid + CellsBeforeFirstVoxel(), ray.directionGrid);
  cell = PlaceAt(cellRay, inside.enter, CellCount());
  float plainMm = CellsPerSegment / length(ray.directionGrid);
  BeginCells(ray);
  for (int index = 0; index < mostSegments && cell.t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment = NextSegment(ray, inside, cell.t, index, plainMm, BlendState(sum));
    if (segment.enter > cell.t)
    {
      cell = PlaceAt(cellRay, segment.enter, CellCount());
    }
    sum = TakeCells(sum, ray, min(segment.exit, inside.exit), inside.exit);
  }
  return sum;
}
