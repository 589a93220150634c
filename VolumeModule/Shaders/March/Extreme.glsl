// A maximum or minimum of interpolated voxels, exactly: in a cell the scalar is a cubic along the
// ray, known from four readings, which has its largest and smallest values at its ends or extremes.

const float CellsPerSegment = 4.0;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  // Cells before the first voxel and behind the last one are cells too: 0 and voxelCount.
  LatticeRay lattice = RayInLattice(ray.originGrid - firstVoxelGrid + 1.0, ray.directionGrid);
  LatticePlace place = PlaceAt(lattice, inside.enter, voxelCount + 1.0);
  float plainMm = CellsPerSegment / length(ray.directionGrid);
  for (int index = 0; index < mostSegments && place.t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment = NextSegment(ray, inside, place.t, index, plainMm, BlendState(sum));
    if (segment.enter > place.t)
    {
      place = PlaceAt(lattice, segment.enter, voxelCount + 1.0);
    }
    float end = min(segment.exit, inside.exit);
    vec4 scalars = vec4(ScalarAt(PositionTexture(ray, place.t)));
    while (place.t < end)
    {
      float enter = place.t;
      place = BehindBlock(lattice, place, 0.0);
      float exit = min(place.t, inside.exit);
      scalars = vec4(scalars.w, ScalarAt(PositionTexture(ray, mix(enter, exit, 1.0 / 3.0))),
        ScalarAt(PositionTexture(ray, mix(enter, exit, 2.0 / 3.0))),
        ScalarAt(PositionTexture(ray, exit)));
      vec4 cubic = CubicThrough(scalars);
      vec2 extremes = CubicExtremes(cubic);
      sum = BlendScalar(sum, cubic.x, 0.0);
      sum = BlendScalar(sum, CubicValue(cubic, extremes.x), 0.0);
      sum = BlendScalar(sum, CubicValue(cubic, extremes.y), 0.0);
      sum = BlendScalar(sum, cubic.w, 0.0);
    }
  }
  return sum;
}
