#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Steps for a maximum or minimum: bricks that cannot improve the value that the ray has found are
// skipped. The field's texel holds the largest scalar of a brick, or for a minimum the smallest,
// or one that looks the same (Core/Fields/ExtremeBricks.h).

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  LatticeRay lattice =
    RayInLattice(ray.originGrid / cellsPerBrick, ray.directionGrid / cellsPerBrick);
  LatticePlace place = PlaceAt(lattice, t, fieldSize);
  for (int skip = 0; skip < mostSegments && place.t < inside.exit; ++skip)
  {
    float texel = textureLod(fieldTexture, (place.cell + 0.5) * fieldSizeInverse, 0.0).r;
    if (sense * (texel * 65535.0 * scalarFromField.x + scalarFromField.y - blendState) > 0.0)
    {
      break;
    }
    place = BehindCell(lattice, place);
  }
  return Interval(place.t, place.t + PlainMm(index, plainMm));
}
