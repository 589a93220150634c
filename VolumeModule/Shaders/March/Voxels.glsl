// Voxels without interpolation: boxes of one value, which reach half a voxel to every side. A ray
// goes from face to face and reads each voxel once, at its middle: what it takes in is exact.

const float VoxelsPerSegment = 4.0;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid + 0.5, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, voxelCount);
  float plainMm = VoxelsPerSegment / length(ray.directionGrid);
  for (int index = 0; index < mostSegments && place.t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment = NextSegment(ray, inside, place.t, index, plainMm, BlendState(sum));
    if (segment.enter > place.t)
    {
      place = PlaceAt(lattice, segment.enter, voxelCount);
    }
    float end = min(segment.exit, inside.exit);
    while (place.t < end)
    {
      LatticePlace behind = BehindBlock(lattice, place, 0.0);
      sum =
        BlendVoxel(sum, (place.cell + 0.5) / voxelCount, ray, min(behind.t, inside.exit) - place.t);
      place = behind;
    }
  }
  return sum;
}
