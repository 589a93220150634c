// Isosurfaces of voxels without interpolation (see Voxels.glsl): the faces between a voxel of at
// least the isovalue and one of less.

const float VoxelsPerSegment = 4.0;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid + 0.5, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, voxelCount);
  float before = ScalarAt((place.cell + 0.5) / voxelCount);
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
      vec3 middleTexture = (place.cell + 0.5) / voxelCount;
      float scalar = ScalarAt(middleTexture);
      vec3 gradient = GradientAt(middleTexture);
      for (int i = 0; i < isosurfaceCount; ++i)
      {
        int surface = scalar > before ? i : isosurfaceCount - 1 - i;
        if (IsPassed(surface, before, scalar))
        {
          sum = BlendSurface(sum, surface, gradient, ray, place.t);
        }
      }
      before = scalar;
      place = BehindBlock(lattice, place, 0.0);
    }
  }
  return sum;
}
