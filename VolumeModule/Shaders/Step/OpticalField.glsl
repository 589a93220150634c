#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
#include "Math/StepGrowth.glsl"
// Steps by the optical field: invisible blocks are skipped, a homogeneous brick is one segment, and
// structured bricks are marched at the sample distance. The field's texel is 0 for a structured
// brick, 1 for a homogeneous one, and 128 + k if the bricks b - k to b + k, or those of them that
// lie in the direction of the rays, are invisible.

Interval NextOfField(Ray ray, Interval inside, float t, float plainMm)
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
  float plain = place.t + plainMm;
  return Interval(place.t, content < 0.5 ? plain : max(plain, behind.t));
}

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  return NextOfField(ray, inside, t, StepGrowth(blendState) * PlainMm(index, plainMm));
}
