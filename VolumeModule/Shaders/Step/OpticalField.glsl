// Steps by the optical field: invisible blocks are left at once, a homogeneous brick is one
// segment, structured ones are marched at the sample distance.
// The field's texel holds 0 where the brick is structured, 1 where it is homogeneous, 128 + k
// where all bricks b - k ... b + k are invisible, or those of them that lie towards the rays.

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  LatticeRay lattice =
    RayInLattice(ray.originGrid / cellsPerBrick, ray.directionGrid / cellsPerBrick);
  LatticePlace place = PlaceAt(lattice, t, fieldSize);
  LatticePlace behind = place;
  float content = 0.0;
  for (int skip = 0; skip < mostSegments; ++skip)
  {
    content =
      floor(textureLod(fieldTexture, (place.cell + 0.5) * fieldSizeInverse, 0.0).r * 255.0 + 0.5);
    behind = BehindBlock(lattice, place, max(content - 128.0, 0.0));
    if (content < 127.5)
    {
      break;
    }
    place = behind;
    if (place.t >= inside.exit)
    {
      break;
    }
  }
  float plain = place.t + StepGrowth(blendState) * PlainMm(index, plainMm);
  return Interval(place.t, content < 0.5 ? plain : max(plain, behind.t));
}
