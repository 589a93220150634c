// The loop along a ray from cell to cell of a lattice. Steps of a few cells at a time let the ray
// leave out what cannot be seen. The file in March takes in the cells, exactly:

vec3 CellCount();
float CellsBeforeFirstVoxel(); // up to the middle of the first voxel
void BeginCells(Ray ray);      // when the ray is in its first cell
// Goes on with the ray to the end of the cell that it is in at `end`; it leaves the volume at
// `exit`.
Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit);

LatticeRay cellRay;
LatticePlace cell; // that the ray is in

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
