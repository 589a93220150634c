// Isosurfaces of interpolated voxels. In a cell the scalar is a cubic along the ray, known from
// four readings. It is cut where it has extremes, so that no surface is missed, however thin what
// it bounds; neighbouring cells share the reading at their face, so that none is passed twice.

const float CellsPerSegment = 4.0;

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

// Takes in the surfaces of a piece, within a part of the ray, on which the cubic is monotone.
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
    while (place.t < end && !BlendFinished(sum))
    {
      Interval part;
      vec4 cubic;
      do
      {
        part.enter = place.t;
        place = BehindBlock(lattice, place, 0.0);
        part.exit = min(place.t, inside.exit);
        cubic = CubicThrough(ScalarsOfCell(ray, part));
      } while (place.t < end && !MayHoldSurface(cubic));

      vec2 extremes = CubicExtremes(cubic);
      sum = BlendMonotone(sum, cubic, vec2(0.0, extremes.x), ray, part);
      sum = BlendMonotone(sum, cubic, extremes, ray, part);
      sum = BlendMonotone(sum, cubic, vec2(extremes.y, 1.0), ray, part);
    }
  }
  return sum;
}
