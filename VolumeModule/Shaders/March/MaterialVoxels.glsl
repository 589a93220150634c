// Voxels without interpolation (see Voxels.glsl), of materials that depend on gradients or on
// several values. A voxel has one gradient, that at its middle; it is fetched for voxels only that
// absorb anything, which an inner loop looks for (see MaterialSegments.glsl).

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
    while (place.t < end && !BlendFinished(sum))
    {
      Values values;
      vec3 middleTexture;
      Interval part;
      do
      {
        LatticePlace behind = BehindBlock(lattice, place, 0.0);
        middleTexture = (place.cell + 0.5) / voxelCount;
        part = Interval(place.t, min(behind.t, inside.exit));
        values = ValuesAt(middleTexture);
        place = behind;
      } while (place.t < end && !MayAbsorb(values, values));

      float lengthMm = part.exit - part.enter;
      vec4 optical = Material(values, GradientsAt(middleTexture), ray, part.enter + 0.5 * lengthMm);
      sum = BlendPart(sum, optical.rgb, optical.a * lengthMm);
    }
  }
  return sum;
}
